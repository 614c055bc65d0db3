package team;

import java.util.List;
import protos.Playmaker.CoachActions;
import protos.Playmaker.GameModeType;
import protos.Playmaker.PlayerAction;
import protos.Playmaker.PlayerActions;
import protos.Playmaker.State;
import protos.Playmaker.TrainerActions;
import protos.Playmaker.WorldModel;

/** The team's decisions: the place for your own ideas. */
final class Decide {
    private Decide() {}

    /** The actions of one player for one cycle; the first possible body action is executed. */
    static PlayerActions decide(State state) {
        return PlayerActions.newBuilder().addAllActions(choose(state.getWorldModel())).build();
    }

    private static List<PlayerAction> choose(WorldModel world) {
        if (world.getGameModeType() != GameModeType.PlayOn) {
            return List.of(Actions.setPlay());
        }
        if (world.getSelf().getIsGoalie()) {
            return List.of(Actions.goalie());
        }
        if (world.getSelf().getIsKickable()) {
            Point ball = Point.of(world.getBall().getPosition());
            return List.of(
                Actions.showLine(ball, Point.GOAL, "yellow"),
                Actions.showText("has the ball"),
                Actions.smartKick(Point.GOAL, 3, 0.1, 3), Actions.watchBall(0));
        }
        return List.of(Actions.basicMove());
    }

    static CoachActions decideAsCoach(State state) {
        return CoachActions.newBuilder().addActions(Actions.substitute()).build();
    }

    static TrainerActions decideAsTrainer(State state) {
        return TrainerActions.getDefaultInstance();
    }
}
