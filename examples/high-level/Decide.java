package team;

import java.util.ArrayList;
import java.util.List;
import protos.Playmaker.ActionTypeEffector;
import protos.Playmaker.CoachActions;
import protos.Playmaker.GameModeType;
import protos.Playmaker.HeliosOffensivePlanner;
import protos.Playmaker.OpponentEffector;
import protos.Playmaker.PlannerEvaluation;
import protos.Playmaker.PlannerEvaluationEffector;
import protos.Playmaker.PlayerAction;
import protos.Playmaker.PlayerActions;
import protos.Playmaker.Self;
import protos.Playmaker.State;
import protos.Playmaker.TrainerActions;
import protos.Playmaker.WorldModel;

/** The team's decisions by the behaviors of the proxy: which of them, and with which values. */
final class Decide {
    private static final double SHOT = 20; // meters to the goal

    private Decide() {}

    /** The actions of one player for one cycle; the first possible body action is executed. */
    static PlayerActions decide(State state) {
        return PlayerActions.newBuilder().addAllActions(choose(state.getWorldModel())).build();
    }

    private static List<PlayerAction> choose(WorldModel world) {
        Self self = world.getSelf();
        if (world.getIsPenaltyKickMode()) {
            return List.of(Actions.penalty());
        }
        if (world.getGameModeType() != GameModeType.PlayOn) {
            return List.of(Actions.setPlay());
        }
        if (self.getIsGoalie()) {
            return List.of(Actions.goalie());
        }
        if (self.getIsKickable()) {
            boolean defends = self.getUniformNumber() >= 2 && self.getUniformNumber() <= 5;
            List<PlayerAction> chosen = new ArrayList<>(List.of(Actions.shoot()));
            if (Point.of(world.getBall().getPosition()).distance(Point.GOAL) < SHOT) {
                chosen.add(Actions.smartKick(Point.GOAL, 3, 2, 2));
            }
            chosen.addAll(List.of(plan(defends), Actions.holdBall(Point.GOAL),
                Actions.watchBall(0)));
            return chosen;
        }
        return List.of(Actions.basicMove(), Actions.watchBall(1));
    }

    /** Searches chains of passes and dribbles. Defenders pass rather than dribble. */
    private static PlayerAction plan(boolean defends) {
        return PlayerAction.newBuilder().setHeliosOffensivePlanner(
            HeliosOffensivePlanner.newBuilder()
                .setDirectPass(true).setLeadPass(true).setThroughPass(true).setShortDribble(true)
                .setLongDribble(!defends).setCross(!defends).setSimplePass(true)
                .setSimpleDribble(true).setSimpleShoot(true).setEvaluation(evaluation(defends)))
            .build();
    }

    /** Factors by the first action of a chain, and costs of opponents at 0, 1, 2, ... meters. */
    private static PlannerEvaluation evaluation(boolean defends) {
        ActionTypeEffector factors = ActionTypeEffector.newBuilder()
            .setDirectPass(defends ? 1.2f : 1).setLeadPass(1).setThroughPass(1.1f)
            .setShortDribble(defends ? 0.8f : 1).setLongDribble(1).setCross(1).setHold(1).build();
        OpponentEffector near = OpponentEffector.newBuilder()
            .addAllNegetiveEffectByDistance(List.of(-8f, -5f, -2f)).build();
        return PlannerEvaluation.newBuilder().setEffectors(PlannerEvaluationEffector.newBuilder()
            .setActionTypeEffector(factors).setOpponentEffector(near)).build();
    }

    static CoachActions decideAsCoach(State state) {
        return CoachActions.newBuilder().addActions(Actions.substitute())
            .addActions(Actions.sayPlayerTypes()).build();
    }

    static TrainerActions decideAsTrainer(State state) {
        return TrainerActions.getDefaultInstance();
    }
}
