// The team's decisions: the place for your own ideas.
using Protos;

namespace Team;

public static class Decide
{
    /// <summary>The actions of one player for one cycle; the first possible body action is executed.</summary>
    public static PlayerActions AsPlayer(State state)
    {
        var world = state.WorldModel;
        if (world.GameModeType != GameModeType.PlayOn) return Reply(Actions.SetPlay());
        if (world.Self.IsGoalie) return Reply(Actions.Goalie());
        if (world.Self.IsKickable)
        {
            return Reply(
                Actions.ShowLine(Point.Of(world.Ball.Position), Point.Goal, "yellow"),
                Actions.ShowText("has the ball"),
                Actions.SmartKick(Point.Goal, 3, 0.1, 3), Actions.WatchBall(0));
        }
        return Reply(Actions.BasicMove());
    }

    public static CoachActions AsCoach(State state) => new() { Actions = { Actions.Substitute() } };

    public static TrainerActions AsTrainer(State state) => new();

    private static PlayerActions Reply(params PlayerAction[] actions) =>
        new() { Actions = { actions } };
}
