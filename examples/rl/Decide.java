package team;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import protos.Playmaker.CoachActions;
import protos.Playmaker.GameModeType;
import protos.Playmaker.HeliosOffensivePlanner;
import protos.Playmaker.PlayerAction;
import protos.Playmaker.PlayerActions;
import protos.Playmaker.State;
import protos.Playmaker.TrainerActions;

/** The team's decisions: a policy chooses what to do with the ball, the proxy does the rest. */
final class Decide {
    /** The weights of an action. */
    private record Row(String action, double[] weights) {
        double score(double[] features) {
            return IntStream.range(0, weights.length).mapToDouble(i -> weights[i] * features[i])
                .sum();
        }
    }

    private static final List<Row> POLICY = readPolicy();

    private Decide() {}

    private static List<Row> readPolicy() {
        String path = System.getenv().getOrDefault("POLICY", "policy.txt");
        try (Stream<String> lines = Files.lines(Path.of(path))) {
            return lines.filter(line -> !line.isBlank() && !line.startsWith("#"))
                .map(line -> line.trim().split("\\s+"))
                .map(words -> new Row(words[0], Arrays.stream(words).skip(1)
                    .mapToDouble(Double::parseDouble).toArray()))
                .toList();
        } catch (IOException error) {
            throw new UncheckedIOException(error);
        }
    }

    /** What the policy sees, each about 0 to 1: bias, goal, room, lane, own_half. */
    private static double[] features(Situation now) {
        Point ahead = new Point(now.me.x() + 8, now.me.y());
        return new double[] {1, Math.max(0, 1 - now.ball.distance(Point.GOAL) / 50),
            Math.min(now.room(now.ball), 10) / 10,
            Math.min(Math.max(now.lane(now.me, ahead), 0), 4) / 4, now.ball.x() < 0 ? 1 : 0};
    }

    private static PlayerAction action(String name) {
        return switch (name) {
            case "shoot" -> Actions.smartKick(Point.GOAL, 3, 2, 2);
            case "pass" -> PlayerAction.newBuilder().setHeliosOffensivePlanner(
                HeliosOffensivePlanner.newBuilder().setDirectPass(true).setLeadPass(true)
                    .setThroughPass(true).setMaxDepth(1)).build();
            case "dribble" -> Actions.dribble(Point.GOAL, 90, 4);
            case "clear" -> Actions.clearBall();
            default -> Actions.holdBall(Point.GOAL);
        };
    }

    /** All actions, the one with the highest score first: the first possible one is executed. */
    private static List<PlayerAction> withBall(Situation now) {
        double[] seen = features(now);
        Stream<PlayerAction> ranked = POLICY.stream()
            .sorted(Comparator.comparingDouble(row -> -row.score(seen)))
            .map(row -> action(row.action()));
        return Stream.concat(ranked, Stream.of(Actions.watchBall(0))).toList();
    }

    /** The actions of one player for one cycle. */
    static PlayerActions decide(State state) {
        return PlayerActions.newBuilder().addAllActions(choose(new Situation(state))).build();
    }

    private static List<PlayerAction> choose(Situation now) {
        if (now.world.getIsPenaltyKickMode()) {
            return List.of(Actions.penalty());
        }
        if (now.world.getGameModeType() != GameModeType.PlayOn) {
            return List.of(Actions.setPlay());
        }
        if (now.self.getIsGoalie()) {
            return List.of(Actions.goalie());
        }
        return now.self.getIsKickable() ? withBall(now)
            : List.of(Actions.basicMove(), Actions.watchBall(1));
    }

    static CoachActions decideAsCoach(State state) {
        return CoachActions.newBuilder().addActions(Actions.substitute())
            .addActions(Actions.sayPlayerTypes()).build();
    }

    static TrainerActions decideAsTrainer(State state) {
        return TrainerActions.getDefaultInstance();
    }
}
