// Constructors of the actions that the team uses. docs/actions.md of cls describes all actions.
using Protos;

namespace Team;

public static class Actions
{
    public static PlayerAction BeforeKickOff(Point place) =>
        new() { BhvBeforeKickOff = new() { Point = Vector(place) } };

    public static PlayerAction SmartKick(Point target, double speed, double minSpeed, int kicks) =>
        new()
        {
            BodySmartKick = new()
            {
                TargetPoint = Vector(target),
                FirstSpeed = (float)speed,
                FirstSpeedThreshold = (float)minSpeed,
                MaxSteps = kicks,
            },
        };

    public static PlayerAction Dribble(Point target, double dashPower, int dashes) =>
        new()
        {
            BodyDribble = new()
            {
                TargetPoint = Vector(target),
                DistanceThreshold = 1,
                DashPower = (float)dashPower,
                DashCount = dashes,
                Dodge = true,
            },
        };

    public static PlayerAction GoTo(Point target, double within, double dashPower) =>
        new()
        {
            BodyGoToPoint = new()
            {
                TargetPoint = Vector(target),
                DistanceThreshold = (float)within,
                MaxDashPower = (float)dashPower,
            },
        };

    public static PlayerAction Intercept(Point face) =>
        new() { BodyIntercept = new() { FacePoint = Vector(face) } };

    public static PlayerAction HoldBall(Point face) =>
        new()
        {
            BodyHoldBall = new()
            {
                DoTurn = true,
                TurnTargetPoint = Vector(face),
                KickTargetPoint = Vector(face),
            },
        };

    public static PlayerAction ClearBall() => new() { BodyClearBall = new() };

    public static PlayerAction TurnToBall() => new() { BodyTurnToBall = new() { Cycle = 1 } };

    /// <summary>Beside the player in the page of the match; moves nothing.</summary>
    public static PlayerAction ShowText(string text) =>
        new() { Log = new() { AddText = new() { Level = LoggerLevel.Team, Message = text } } };

    /// <summary>On the field in the page of the match; moves nothing.</summary>
    public static PlayerAction ShowLine(Point start, Point end, string color) =>
        new()
        {
            Log = new()
            {
                AddLine = new()
                {
                    Level = LoggerLevel.Team,
                    Start = Vector(start),
                    End = Vector(end),
                    Color = color,
                },
            },
        };

    /// <summary>With the ball: the best of the passes and dribbles that the proxy finds.</summary>
    public static PlayerAction PlanAttack() =>
        new()
        {
            HeliosOffensivePlanner = new()
            {
                DirectPass = true,
                LeadPass = true,
                ThroughPass = true,
                ShortDribble = true,
                LongDribble = true,
                Cross = true,
                SimplePass = true,
                SimpleDribble = true,
            },
        };

    /// <summary>The neck: to the ball if its estimate is older than maxAge cycles, else around.</summary>
    public static PlayerAction WatchBall(int maxAge) =>
        new() { NeckTurnToBallOrScan = new() { CountThreshold = maxAge } };

    public static PlayerAction WatchGoalie() => new() { NeckTurnToGoalieOrScan = new() };

    public static PlayerAction Shoot() => new() { HeliosShoot = new() };

    /// <summary>Without the ball: tackle, block, mark, or move to the proxy's own formation.</summary>
    public static PlayerAction BasicMove() => new() { HeliosBasicMove = new() };

    public static PlayerAction Goalie() => new() { HeliosGoalie = new() };

    public static PlayerAction SetPlay() => new() { HeliosSetPlay = new() };

    public static PlayerAction Penalty() => new() { HeliosPenalty = new() };

    public static CoachAction Substitute() => new() { DoHeliosSubstitute = new() };

    public static CoachAction SayPlayerTypes() => new() { DoHeliosSayPlayerTypes = new() };

    private static RpcVector2D Vector(Point place) => // + 0.0: never a negative zero
        new() { X = (float)(place.X + 0.0), Y = (float)(place.Y + 0.0) };
}
