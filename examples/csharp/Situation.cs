// What a player knows in one cycle: geometry and facts derived from a State.
// Only + - * / and sqrt, in a fixed order: every language computes the same bits.
using Protos;

namespace Team;

/// <summary>A position on the pitch in meters.</summary>
public readonly record struct Point(double X, double Y)
{
    /// <summary>The opponent's: every team attacks toward +x.</summary>
    public static readonly Point Goal = new(52.5, 0);

    public static Point Of(RpcVector2D? vector) => vector is null ? default : new(vector.X, vector.Y);

    public double Distance(Point other)
    {
        var dx = X - other.X;
        var dy = Y - other.Y;
        return Math.Sqrt(dx * dx + dy * dy);
    }
}

/// <summary>The State of one player, with the facts that most decisions begin with.</summary>
public sealed class Situation
{
    public const int Far = 1000; // meters or cycles: no player is there
    private const int MaxAge = 20; // cycles; older estimates of players are ignored

    public WorldModel World { get; }
    public Self Self { get; }
    public Point Me { get; }
    public Point Ball { get; }
    public IReadOnlyList<Point> Opponents { get; }

    // Cycles to the ball: of this player, its fastest teammate, the fastest opponent.
    public int MySteps { get; }
    public int OurSteps { get; }
    public int TheirSteps { get; }

    public Situation(State state)
    {
        World = state.WorldModel;
        Self = World.Self;
        Me = Point.Of(Self.Position);
        Ball = Point.Of(World.Ball?.Position);
        Opponents = [.. World.Opponents.Where(player => player.PosCount <= MaxAge)
            .Select(player => Point.Of(player.Position))];
        var table = World.InterceptTable;
        MySteps = Self.IsKickable ? 0 : table.SelfReachSteps;
        OurSteps = Steps(World.KickableTeammateExistance, table.FirstTeammateId,
            table.FirstTeammateReachSteps);
        TheirSteps = Steps(World.KickableOpponentExistance, table.FirstOpponentId,
            table.FirstOpponentReachSteps);
    }

    /// <summary>The distance of the nearest opponent.</summary>
    public double Room(Point place)
    {
        double nearest = Far;
        foreach (var opponent in Opponents) nearest = Math.Min(nearest, opponent.Distance(place));
        return nearest;
    }

    /// <summary>
    /// How far opponents stay away from a ball that rolls from start to end; below 0: they reach it.
    /// An opponent reaches 0.8 m, and 0.2 m more for each meter that the ball rolls.
    /// </summary>
    public double Lane(Point start, Point end)
    {
        var dx = end.X - start.X;
        var dy = end.Y - start.Y;
        var length = Math.Sqrt(dx * dx + dy * dy);
        if (length < 0.1) return Far;
        double free = Far;
        foreach (var opponent in Opponents)
        {
            var along = ((opponent.X - start.X) * dx + (opponent.Y - start.Y) * dy) / length;
            if (along < 0) continue;
            along = Math.Min(along, length);
            var share = along / length;
            var passed = new Point(start.X + dx * share, start.Y + dy * share);
            free = Math.Min(free, opponent.Distance(passed) - 0.8 - 0.2 * along);
        }
        return free;
    }

    // Cycles to the ball; a player id of 0 means that no such player is known.
    private static int Steps(bool kickable, int playerId, int cycles) =>
        kickable ? 0 : playerId != 0 ? cycles : Far;
}
