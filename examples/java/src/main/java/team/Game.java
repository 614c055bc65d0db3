package team;

import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import io.grpc.stub.StreamObserver;
import java.util.Comparator;
import java.util.Map;
import java.util.function.Supplier;
import java.util.logging.Level;
import java.util.logging.Logger;
import protos.GameGrpc;
import protos.Playmaker.*;

/** Implements protos.Game: one call per agent and cycle. */
final class Game extends GameGrpc.GameImplBase {
    private static final Logger LOG = Logger.getLogger("team");
    private final boolean withCoach;

    Game(boolean withCoach) {
        this.withCoach = withCoach;
    }

    RegisterResponse register(RegisterRequest request) {
        return RegisterResponse.newBuilder().setClientId(request.getUniformNumber())
            .setAgentType(request.getAgentType()).setTeamName(request.getTeamName())
            .setUniformNumber(request.getUniformNumber())
            .setRpcServerLanguageType(RpcServerLanguageType.JAVA).build();
    }

    CoachActions coachActions(State state) {
        if (!withCoach) {
            throw Status.UNIMPLEMENTED.withDescription("started without --coach")
                .asRuntimeException();
        }
        return Decide.decideAsCoach(state);
    }

    /** The node with the highest value; the lowest index among equal ones. */
    BestPlannerActionResponse bestPlannerAction(BestPlannerActionRequest request) {
        Comparator<Map.Entry<Integer, RpcActionState>> byValue =
            Comparator.comparingDouble(node -> node.getValue().getEvaluation());
        int best = request.getPairsMap().entrySet().stream()
            .max(byValue.thenComparing(Map.Entry::getKey, Comparator.reverseOrder()))
            .map(Map.Entry::getKey).orElse(-1);
        return BestPlannerActionResponse.newBuilder().setIndex(best).build();
    }

    @Override
    public void register(RegisterRequest request, StreamObserver<RegisterResponse> reply) {
        send(reply, () -> register(request));
    }

    @Override
    public void sendServerParams(ServerParam request, StreamObserver<Empty> reply) {
        send(reply, Empty::getDefaultInstance);
    }

    @Override
    public void sendPlayerParams(PlayerParam request, StreamObserver<Empty> reply) {
        send(reply, Empty::getDefaultInstance);
    }

    @Override
    public void sendPlayerType(PlayerType request, StreamObserver<Empty> reply) {
        send(reply, Empty::getDefaultInstance);
    }

    @Override
    public void sendInitMessage(InitMessage request, StreamObserver<Empty> reply) {
        send(reply, Empty::getDefaultInstance);
    }

    @Override
    public void sendByeCommand(RegisterResponse request, StreamObserver<Empty> reply) {
        send(reply, Empty::getDefaultInstance);
    }

    @Override
    public void getPlayerActions(State state, StreamObserver<PlayerActions> reply) {
        send(reply, () -> Decide.decide(state));
    }

    @Override
    public void getCoachActions(State state, StreamObserver<CoachActions> reply) {
        send(reply, () -> coachActions(state));
    }

    @Override
    public void getTrainerActions(State state, StreamObserver<TrainerActions> reply) {
        send(reply, () -> Decide.decideAsTrainer(state));
    }

    @Override
    public void getBestPlannerAction(BestPlannerActionRequest request,
                                     StreamObserver<BestPlannerActionResponse> reply) {
        send(reply, () -> bestPlannerAction(request));
    }

    /** Replies; an exception becomes the status of the call. */
    static <T> void send(StreamObserver<T> reply, Supplier<T> method) {
        T message;
        try {
            message = method.get();
        } catch (RuntimeException error) {
            reply.onError(status(error).asRuntimeException());
            return;
        }
        reply.onNext(message);
        reply.onCompleted();
    }

    /** The status for an exception of a method, which is logged with its stack trace. */
    static Status status(RuntimeException error) {
        if (error instanceof StatusRuntimeException chosen) {
            return chosen.getStatus();
        }
        LOG.log(Level.SEVERE, "a call failed", error);
        StackTraceElement place = error.getStackTrace()[0];
        return Status.UNKNOWN.withDescription(
            error + " (" + place.getFileName() + ":" + place.getLineNumber() + ")");
    }
}
