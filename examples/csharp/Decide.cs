// The team's decisions: the place for your own ideas. examples/TEAM.md of cls describes the team.
using Protos;

namespace Team;

public static class Decide
{
    /// <summary>A position with the ball at the center mark, and how much of the ball's way it follows.</summary>
    private sealed record Home(
        double X, double Y, double FollowX, double FollowY, double MinX, double MaxX, Point KickOff);

    private sealed record Pass(Point Target, double Speed, double Value);

    private static readonly Home[] Formation = // 4-3-3 by uniform number; 1 is the goalie
    [
        new(-50, 0, 0, 0, -50, -50, new(-50, 0)),
        new(-20, -7, 0.60, 0.25, -45, 14, new(-20, -7)),
        new(-20, 7, 0.60, 0.25, -45, 14, new(-20, 7)),
        new(-17, -20, 0.65, 0.25, -43, 28, new(-18, -20)),
        new(-17, 20, 0.65, 0.25, -43, 28, new(-18, 20)),
        new(-7, 0, 0.70, 0.45, -38, 32, new(-11, 0)),
        new(1, -12, 0.75, 0.35, -34, 40, new(-8, -11)),
        new(1, 12, 0.75, 0.35, -34, 40, new(-8, 11)),
        new(15, -25, 0.75, 0.15, -24, 47, new(-1.5, -22)),
        new(15, 25, 0.75, 0.15, -24, 47, new(-1.5, 22)),
        new(18, 0, 0.75, 0.30, -16, 47, new(-0.8, 0)),
    ];

    private static readonly Point[] DribbleDirections = // exact sides of a right triangle
        [new(1, 0), new(0.8, 0.6), new(0.8, -0.6), new(0.6, 0.8), new(0.6, -0.8)]; // 37, 53 degrees

    private static readonly double[] ShotTargets = [-6, -3, 0, 3, 6]; // y on the goal line

    /// <summary>The actions of one player for one cycle; the first possible body action is executed.</summary>
    public static PlayerActions AsPlayer(State state)
    {
        var now = new Situation(state);
        var mode = now.World.GameModeType;
        if (now.World.IsPenaltyKickMode) return Reply(Actions.Penalty());
        if (mode is GameModeType.BeforeKickOff or GameModeType.AfterGoal)
        {
            var own = Formation[now.Self.UniformNumber - 1];
            var reply = Reply(Actions.BeforeKickOff(own.KickOff), Actions.WatchBall(0));
            reply.IgnorePreprocess = true;
            return reply;
        }
        if (mode != GameModeType.PlayOn) return Reply(Actions.SetPlay());
        if (now.Self.IsGoalie) return Reply(Actions.Goalie());
        return Reply(now.Self.IsKickable ? WithBall(now) : WithoutBall(now));
    }

    /// <summary>Substitutions, and the opponents' player types for the players.</summary>
    public static CoachActions AsCoach(State state) =>
        new() { Actions = { Actions.Substitute(), Actions.SayPlayerTypes() } };

    /// <summary>A trainer may move ball and players: a place for exercises. This one watches.</summary>
    public static TrainerActions AsTrainer(State state) => new();

    private static PlayerActions Reply(params PlayerAction[] actions) =>
        new() { Actions = { actions } };

    private static PlayerAction[] WithBall(Situation now)
    {
        List<PlayerAction> chosen = [Actions.Shoot()];
        var corner = Shot(now);
        if (corner is { } target) chosen.Add(Actions.SmartKick(target, 3, 2, 2));
        var pressed = now.Room(now.Ball) < 3;
        if (BestPass(now) is { } best && (pressed || best.Value > Value(now, now.Ball) + 2))
        {
            chosen.Add(Actions.SmartKick(best.Target, best.Speed, best.Speed * 0.8, 3));
        }
        if (pressed && now.Ball.X < -20) chosen.Add(Actions.ClearBall());
        chosen.Add(Actions.Dribble(DribbleTarget(now), 90, pressed ? 2 : 4));
        chosen.Add(Actions.HoldBall(Point.Goal));
        chosen.Add(corner is null ? Actions.WatchBall(0) : Actions.WatchGoalie());
        return [.. chosen];
    }

    /// <summary>The place between the posts that opponents are farthest from.</summary>
    private static Point? Shot(Situation now)
    {
        if (now.Ball.Distance(Point.Goal) > 20) return null;
        Point? best = null;
        double widest = 0;
        foreach (var y in ShotTargets)
        {
            var target = Point.Goal with { Y = y };
            var margin = now.Lane(now.Ball, target);
            if (margin > widest) (best, widest) = (target, margin);
        }
        return best;
    }

    /// <summary>Of the ball at a place: forward, near the goal, away from opponents.</summary>
    private static double Value(Situation now, Point place) =>
        place.X - 0.2 * place.Distance(Point.Goal) + 0.6 * Math.Min(now.Room(place), 8);

    private static Pass? BestPass(Situation now)
    {
        Pass? best = null;
        foreach (var mate in now.World.Teammates)
        {
            if (mate.PosCount > 8 || mate.IsGoalie || mate.IsTackling) continue;
            var place = Point.Of(mate.Position);
            if (place.X > 0 && place.X > now.World.OffsideLineX - 0.3 && place.X > now.Ball.X)
            {
                continue; // offside
            }
            double ahead = place.X < 36 ? 3 : 0;
            var run = Point.Of(mate.Velocity);
            var target = new Point(Math.Clamp(place.X + 2 * run.X + ahead, -50, 50),
                Math.Clamp(place.Y + 2 * run.Y, -32, 32));
            var length = now.Ball.Distance(target);
            if (length < 5 || length > 32 || (target.X < -25 && target.X < now.Ball.X))
            {
                continue; // too short, too long, or toward the own goal
            }
            if (now.Lane(now.Ball, target) < 0) continue;
            var value = Value(now, target);
            if (best is null || value > best.Value)
            {
                best = new Pass(target, Math.Min(1.2 + 0.06 * length, 2.7), value);
            }
        }
        return best;
    }

    /// <summary>8 m ahead toward the goal, past the opponents in the way.</summary>
    private static Point DribbleTarget(Situation now)
    {
        var away = now.Me.Distance(Point.Goal);
        if (away < 0.1) return Point.Goal;
        var dx = (Point.Goal.X - now.Me.X) / away;
        var dy = (Point.Goal.Y - now.Me.Y) / away;
        var best = Point.Goal;
        double bestRoom = -1000;
        for (var index = 0; index < DribbleDirections.Length; index++)
        {
            var turn = DribbleDirections[index];
            var target = new Point(now.Me.X + 8 * (dx * turn.X - dy * turn.Y),
                now.Me.Y + 8 * (dx * turn.Y + dy * turn.X));
            if (target.Y < -32 || target.Y > 32 || target.X > 51) continue;
            var room = Math.Min(now.Lane(now.Me, target), 4) - 0.5 * index;
            if (room > bestRoom) (best, bestRoom) = (target, room);
        }
        return best;
    }

    private static PlayerAction[] WithoutBall(Situation now)
    {
        var first = now.MySteps <= now.OurSteps;
        if (first && now.MySteps <= now.TheirSteps + 1)
        {
            return [Actions.Intercept(Point.Goal), Actions.TurnToBall(), Actions.WatchBall(0)];
        }
        if (now.TheirSteps <= now.OurSteps || first)
        {
            return [Actions.BasicMove(), Actions.WatchBall(1)];
        }
        var place = HomePosition(now);
        return [Actions.GoTo(place, 0.8, DashPower(now, place)), Actions.TurnToBall(),
            Actions.WatchBall(2)];
    }

    /// <summary>The formation moves with the ball; forwards wait on the offside line.</summary>
    private static Point HomePosition(Situation now)
    {
        var own = Formation[now.Self.UniformNumber - 1];
        var line = now.World.OffsideLineX - 0.5;
        var x = Math.Clamp(own.X + own.FollowX * now.Ball.X, own.MinX, own.MaxX);
        if (now.Self.UniformNumber >= 9)
        {
            x = Math.Max(x, Math.Min(Math.Min(line, now.Ball.X + 22), 46));
        }
        x = Math.Min(x, Math.Max(line, 0));
        return new(x, Math.Clamp(own.Y + own.FollowY * now.Ball.Y, -32, 32));
    }

    /// <summary>Stamina must last for a half.</summary>
    private static double DashPower(Situation now, Point target)
    {
        if (now.Self.Stamina < 3500) return 35;
        return now.Me.X > target.X + 3 || now.Ball.Distance(target) < 15 ? 100 : 65;
    }
}
