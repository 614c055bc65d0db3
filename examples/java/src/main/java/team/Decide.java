package team;

import java.util.ArrayList;
import java.util.List;
import protos.Playmaker.CoachActions;
import protos.Playmaker.GameModeType;
import protos.Playmaker.Player;
import protos.Playmaker.PlayerAction;
import protos.Playmaker.PlayerActions;
import protos.Playmaker.State;
import protos.Playmaker.TrainerActions;

/** The team's decisions: the place for your own ideas. examples/TEAM.md of cls describes the team. */
final class Decide {
    /** A position with the ball at the center mark, and how much of the ball's way it follows. */
    private record Home(double x, double y, double followX, double followY, double minX,
                        double maxX, Point kickOff) {}

    private record Pass(Point target, double speed, double value) {}

    private static final Home[] FORMATION = { // 4-3-3 by uniform number; 1 is the goalie
        new Home(-50, 0, 0, 0, -50, -50, new Point(-50, 0)),
        new Home(-20, -7, 0.60, 0.25, -45, 14, new Point(-20, -7)),
        new Home(-20, 7, 0.60, 0.25, -45, 14, new Point(-20, 7)),
        new Home(-17, -20, 0.65, 0.25, -43, 28, new Point(-18, -20)),
        new Home(-17, 20, 0.65, 0.25, -43, 28, new Point(-18, 20)),
        new Home(-7, 0, 0.70, 0.45, -38, 32, new Point(-11, 0)),
        new Home(1, -12, 0.75, 0.35, -34, 40, new Point(-8, -11)),
        new Home(1, 12, 0.75, 0.35, -34, 40, new Point(-8, 11)),
        new Home(15, -25, 0.75, 0.15, -24, 47, new Point(-1.5, -22)),
        new Home(15, 25, 0.75, 0.15, -24, 47, new Point(-1.5, 22)),
        new Home(18, 0, 0.75, 0.30, -16, 47, new Point(-0.8, 0)),
    };
    /** 0, 37, -37, 53 and -53 degrees: exact sides of a right triangle. */
    private static final Point[] DRIBBLE_DIRECTIONS = {new Point(1, 0), new Point(0.8, 0.6),
        new Point(0.8, -0.6), new Point(0.6, 0.8), new Point(0.6, -0.8)};

    private Decide() {}

    /** The actions of one player for one cycle; the first possible body action is executed. */
    static PlayerActions decide(State state) {
        Situation now = new Situation(state);
        GameModeType mode = now.world.getGameModeType();
        if (now.world.getIsPenaltyKickMode()) {
            return reply(List.of(Actions.penalty()));
        }
        if (mode == GameModeType.BeforeKickOff || mode == GameModeType.AfterGoal_) {
            Home own = FORMATION[now.self.getUniformNumber() - 1];
            return PlayerActions.newBuilder().setIgnorePreprocess(true)
                .addActions(Actions.beforeKickOff(own.kickOff())).addActions(Actions.watchBall(0))
                .build();
        }
        if (mode != GameModeType.PlayOn) {
            return reply(List.of(Actions.setPlay()));
        }
        if (now.self.getIsGoalie()) {
            return reply(List.of(Actions.goalie()));
        }
        return reply(now.self.getIsKickable() ? withBall(now) : withoutBall(now));
    }

    private static PlayerActions reply(List<PlayerAction> actions) {
        return PlayerActions.newBuilder().addAllActions(actions).build();
    }

    /** Substitutions, and the opponents' player types for the players. */
    static CoachActions decideAsCoach(State state) {
        return CoachActions.newBuilder().addActions(Actions.substitute())
            .addActions(Actions.sayPlayerTypes()).build();
    }

    /** A trainer may move ball and players: a place for exercises. This one watches. */
    static TrainerActions decideAsTrainer(State state) {
        return TrainerActions.getDefaultInstance();
    }

    private static List<PlayerAction> withBall(Situation now) {
        List<PlayerAction> chosen = new ArrayList<>();
        chosen.add(Actions.shoot());
        Point corner = shot(now);
        if (corner != null) {
            chosen.add(Actions.smartKick(corner, 3, 2, 2));
        }
        boolean pressed = now.room(now.ball) < 3;
        Pass best = bestPass(now);
        if (best != null && (pressed || best.value() > value(now, now.ball) + 2)) {
            chosen.add(Actions.smartKick(best.target(), best.speed(), best.speed() * 0.8, 3));
        }
        if (pressed && now.ball.x() < -20) {
            chosen.add(Actions.clearBall());
        }
        chosen.add(Actions.dribble(dribbleTarget(now), 90, pressed ? 2 : 4));
        chosen.add(Actions.holdBall(Point.GOAL));
        chosen.add(corner != null ? Actions.watchGoalie() : Actions.watchBall(0));
        return chosen;
    }

    /** The place between the posts that opponents are farthest from; null: none, or too far away. */
    private static Point shot(Situation now) {
        if (now.ball.distance(Point.GOAL) > 20) {
            return null;
        }
        Point best = null;
        double widest = 0;
        for (double y : new double[] {-6, -3, 0, 3, 6}) {
            Point target = new Point(Point.GOAL.x(), y);
            double margin = now.lane(now.ball, target);
            if (margin > widest) {
                best = target;
                widest = margin;
            }
        }
        return best;
    }

    /** Of the ball at a place: forward, near the goal, away from opponents. */
    private static double value(Situation now, Point place) {
        return place.x() - 0.2 * place.distance(Point.GOAL) + 0.6 * Math.min(now.room(place), 8);
    }

    private static Pass bestPass(Situation now) {
        Pass best = null;
        for (Player mate : now.world.getTeammatesList()) {
            if (mate.getPosCount() > 8 || mate.getIsGoalie() || mate.getIsTackling()) {
                continue;
            }
            Point place = Point.of(mate.getPosition());
            double line = (double) now.world.getOffsideLineX() - 0.3;
            if (place.x() > 0 && place.x() > line && place.x() > now.ball.x()) {
                continue; // offside
            }
            double ahead = place.x() < 36 ? 3 : 0;
            Point run = Point.of(mate.getVelocity());
            Point target = new Point(Point.clamp(place.x() + 2 * run.x() + ahead, -50, 50),
                Point.clamp(place.y() + 2 * run.y(), -32, 32));
            double length = now.ball.distance(target);
            if (length < 5 || length > 32 || (target.x() < -25 && target.x() < now.ball.x())) {
                continue; // too short, too long, or toward the own goal
            }
            if (now.lane(now.ball, target) < 0) {
                continue;
            }
            Pass found =
                new Pass(target, Math.min(1.2 + 0.06 * length, 2.7), value(now, target));
            if (best == null || found.value() > best.value()) {
                best = found;
            }
        }
        return best;
    }

    /** 8 m ahead toward the goal, past the opponents in the way. */
    private static Point dribbleTarget(Situation now) {
        double away = now.me.distance(Point.GOAL);
        if (away < 0.1) {
            return Point.GOAL;
        }
        double dx = (Point.GOAL.x() - now.me.x()) / away;
        double dy = (Point.GOAL.y() - now.me.y()) / away;
        Point best = Point.GOAL;
        double bestRoom = -1000;
        for (int index = 0; index < DRIBBLE_DIRECTIONS.length; index++) {
            Point turn = DRIBBLE_DIRECTIONS[index];
            Point target = new Point(now.me.x() + 8 * (dx * turn.x() - dy * turn.y()),
                now.me.y() + 8 * (dx * turn.y() + dy * turn.x()));
            if (target.y() < -32 || target.y() > 32 || target.x() > 51) {
                continue;
            }
            double room = Math.min(now.lane(now.me, target), 4) - 0.5 * index;
            if (room > bestRoom) {
                best = target;
                bestRoom = room;
            }
        }
        return best;
    }

    private static List<PlayerAction> withoutBall(Situation now) {
        boolean first = now.mySteps <= now.ourSteps;
        if (first && now.mySteps <= now.theirSteps + 1) {
            return List.of(Actions.intercept(Point.GOAL), Actions.turnToBall(),
                Actions.watchBall(0));
        }
        if (now.theirSteps <= now.ourSteps || first) {
            return List.of(Actions.basicMove(), Actions.watchBall(1));
        }
        Point place = homePosition(now);
        return List.of(Actions.goTo(place, 0.8, dashPower(now, place)), Actions.turnToBall(),
            Actions.watchBall(2));
    }

    /** The formation moves with the ball; forwards wait on the offside line. */
    private static Point homePosition(Situation now) {
        Home own = FORMATION[now.self.getUniformNumber() - 1];
        double line = (double) now.world.getOffsideLineX() - 0.5;
        double x = Point.clamp(own.x() + own.followX() * now.ball.x(), own.minX(), own.maxX());
        if (now.self.getUniformNumber() >= 9) {
            x = Math.max(x, Math.min(Math.min(line, now.ball.x() + 22), 46));
        }
        x = Math.min(x, Math.max(line, 0));
        return new Point(x, Point.clamp(own.y() + own.followY() * now.ball.y(), -32, 32));
    }

    /** Stamina must last for a half. */
    private static double dashPower(Situation now, Point target) {
        if (now.self.getStamina() < 3500) {
            return 35;
        }
        return now.me.x() > target.x() + 3 || now.ball.distance(target) < 15 ? 100 : 65;
    }
}
