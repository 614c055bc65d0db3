// The team's decisions: a policy chooses what to do with the ball, the proxy does the rest.
using System.Globalization;
using Protos;

namespace Team;

public static class Decide
{
    /// <summary>The weights of an action.</summary>
    private sealed record Row(string Action, double[] Weights)
    {
        public double Score(double[] features) => Weights.Zip(features, (weight, seen) => weight * seen).Sum();
    }

    private static readonly Row[] Policy = ReadPolicy();

    /// <summary>The actions of one player for one cycle.</summary>
    public static PlayerActions AsPlayer(State state)
    {
        var now = new Situation(state);
        if (now.World.IsPenaltyKickMode) return Reply(Actions.Penalty());
        if (now.World.GameModeType != GameModeType.PlayOn) return Reply(Actions.SetPlay());
        if (now.Self.IsGoalie) return Reply(Actions.Goalie());
        if (now.Self.IsKickable) return Reply(WithBall(now));
        return Reply(Actions.BasicMove(), Actions.WatchBall(1));
    }

    public static CoachActions AsCoach(State state) =>
        new() { Actions = { Actions.Substitute(), Actions.SayPlayerTypes() } };

    public static TrainerActions AsTrainer(State state) => new();

    private static PlayerActions Reply(params PlayerAction[] actions) =>
        new() { Actions = { actions } };

    /// <summary>All actions, the one with the highest score first: the first possible one is executed.</summary>
    private static PlayerAction[] WithBall(Situation now)
    {
        var seen = Features(now);
        var ranked = Policy.OrderByDescending(row => row.Score(seen)).Select(row => ActionOf(row.Action));
        return [.. ranked, Actions.WatchBall(0)];
    }

    /// <summary>What the policy sees, each about 0 to 1: bias, goal, room, lane, own_half.</summary>
    private static double[] Features(Situation now)
    {
        var ahead = now.Me with { X = now.Me.X + 8 };
        return
        [
            1,
            Math.Max(0, 1 - now.Ball.Distance(Point.Goal) / 50),
            Math.Min(now.Room(now.Ball), 10) / 10,
            Math.Clamp(now.Lane(now.Me, ahead), 0, 4) / 4,
            now.Ball.X < 0 ? 1 : 0,
        ];
    }

    private static PlayerAction ActionOf(string name) => name switch
    {
        "shoot" => Actions.SmartKick(Point.Goal, 3, 2, 2),
        "pass" => new()
        {
            HeliosOffensivePlanner = new()
            {
                DirectPass = true,
                LeadPass = true,
                ThroughPass = true,
                MaxDepth = 1,
            },
        },
        "dribble" => Actions.Dribble(Point.Goal, 90, 4),
        "clear" => Actions.ClearBall(),
        _ => Actions.HoldBall(Point.Goal),
    };

    private static Row[] ReadPolicy()
    {
        var path = Environment.GetEnvironmentVariable("POLICY");
        return [.. File.ReadLines(string.IsNullOrEmpty(path) ? "policy.txt" : path)
            .Where(line => !string.IsNullOrWhiteSpace(line) && !line.StartsWith('#'))
            .Select(line => line.Split(' ', StringSplitOptions.RemoveEmptyEntries))
            .Select(words => new Row(words[0],
                [.. words.Skip(1).Select(word => double.Parse(word, CultureInfo.InvariantCulture))]))];
    }
}
