// The team's decisions by the behaviors of the proxy: which of them, and with which values.
using Protos;

namespace Team;

public static class Decide
{
    private const double Shot = 20; // meters to the goal

    /// <summary>The actions of one player for one cycle; the first possible body action is executed.</summary>
    public static PlayerActions AsPlayer(State state)
    {
        var world = state.WorldModel;
        var self = world.Self;
        if (world.IsPenaltyKickMode) return Reply(Actions.Penalty());
        if (world.GameModeType != GameModeType.PlayOn) return Reply(Actions.SetPlay());
        if (self.IsGoalie) return Reply(Actions.Goalie());
        if (!self.IsKickable) return Reply(Actions.BasicMove(), Actions.WatchBall(1));
        List<PlayerAction> chosen = [Actions.Shoot()];
        if (Point.Of(world.Ball.Position).Distance(Point.Goal) < Shot)
        {
            chosen.Add(Actions.SmartKick(Point.Goal, 3, 2, 2));
        }
        var defends = self.UniformNumber is >= 2 and <= 5;
        return Reply([.. chosen, Plan(defends), Actions.HoldBall(Point.Goal), Actions.WatchBall(0)]);
    }

    public static CoachActions AsCoach(State state) =>
        new() { Actions = { Actions.Substitute(), Actions.SayPlayerTypes() } };

    public static TrainerActions AsTrainer(State state) => new();

    /// <summary>Searches chains of passes and dribbles. Defenders pass rather than dribble.</summary>
    private static PlayerAction Plan(bool defends) => new()
    {
        HeliosOffensivePlanner = new()
        {
            DirectPass = true,
            LeadPass = true,
            ThroughPass = true,
            ShortDribble = true,
            LongDribble = !defends,
            Cross = !defends,
            SimplePass = true,
            SimpleDribble = true,
            SimpleShoot = true,
            Evaluation = Evaluation(defends),
        },
    };

    /// <summary>Factors by the first action of a chain, and costs of opponents at 0, 1, 2, ... meters.</summary>
    private static PlannerEvaluation Evaluation(bool defends) => new()
    {
        Effectors = new()
        {
            ActionTypeEffector = new()
            {
                DirectPass = defends ? 1.2f : 1,
                LeadPass = 1,
                ThroughPass = 1.1f,
                ShortDribble = defends ? 0.8f : 1,
                LongDribble = 1,
                Cross = 1,
                Hold = 1,
            },
            OpponentEffector = new() { NegetiveEffectByDistance = { -8, -5, -2 } },
        },
    };

    private static PlayerActions Reply(params PlayerAction[] actions) =>
        new() { Actions = { actions } };
}
