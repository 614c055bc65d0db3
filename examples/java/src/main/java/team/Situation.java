package team;

import java.util.List;
import protos.Playmaker.InterceptTable;
import protos.Playmaker.Self;
import protos.Playmaker.State;
import protos.Playmaker.WorldModel;

/** The State of one player, with the facts that most decisions begin with. */
final class Situation {
    static final double FAR = 1000; // meters or cycles: no player is there
    private static final int MAX_AGE = 20; // cycles; older estimates of players are ignored

    final WorldModel world;
    final Self self;
    final Point me;
    final Point ball;
    final List<Point> opponents;
    /** Cycles to the ball: of this player, its fastest teammate, the fastest opponent. */
    final int mySteps;
    final int ourSteps;
    final int theirSteps;

    Situation(State state) {
        world = state.getWorldModel();
        self = world.getSelf();
        me = Point.of(self.getPosition());
        ball = Point.of(world.getBall().getPosition());
        opponents = world.getOpponentsList().stream()
            .filter(player -> player.getPosCount() <= MAX_AGE)
            .map(player -> Point.of(player.getPosition()))
            .toList();
        InterceptTable table = world.getInterceptTable();
        mySteps = self.getIsKickable() ? 0 : table.getSelfReachSteps();
        ourSteps = steps(world.getKickableTeammateExistance(), table.getFirstTeammateId(),
            table.getFirstTeammateReachSteps());
        theirSteps = steps(world.getKickableOpponentExistance(), table.getFirstOpponentId(),
            table.getFirstOpponentReachSteps());
    }

    /** Cycles to the ball; a player id of 0 means that no such player is known. */
    private static int steps(boolean kickable, int playerId, int cycles) {
        if (kickable) {
            return 0;
        }
        return playerId != 0 ? cycles : (int) FAR;
    }

    /** The distance of the nearest opponent. */
    double room(Point place) {
        double nearest = FAR;
        for (Point opponent : opponents) {
            nearest = Math.min(nearest, opponent.distance(place));
        }
        return nearest;
    }

    /**
     * How far opponents stay away from a ball that rolls from start to end; below 0: they reach it.
     * An opponent reaches 0.8 m, and 0.2 m more for each meter that the ball rolls.
     */
    double lane(Point start, Point end) {
        double dx = end.x() - start.x();
        double dy = end.y() - start.y();
        double length = Point.length(dx, dy);
        if (length < 0.1) {
            return FAR;
        }
        double free = FAR;
        for (Point opponent : opponents) {
            double along =
                ((opponent.x() - start.x()) * dx + (opponent.y() - start.y()) * dy) / length;
            if (along < 0) {
                continue;
            }
            along = Math.min(along, length);
            double share = along / length;
            Point passed = new Point(start.x() + dx * share, start.y() + dy * share);
            free = Math.min(free, opponent.distance(passed) - 0.8 - 0.2 * along);
        }
        return free;
    }
}
