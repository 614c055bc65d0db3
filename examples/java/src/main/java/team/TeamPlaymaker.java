package team;

import cls.playmaker.v1.TeamPlaymakerGrpc;
import cls.playmaker.v1.TeamPlaymakerOuterClass.*;
import com.google.protobuf.InvalidProtocolBufferException;
import com.google.protobuf.MessageLite;
import io.grpc.Status;
import io.grpc.stub.StreamObserver;
import java.util.List;
import java.util.function.Function;
import protos.Playmaker.BestPlannerActionRequest;
import protos.Playmaker.RegisterRequest;
import protos.Playmaker.State;

/**
 * Implements cls.playmaker.v1.TeamPlaymaker: one call per team and cycle. It asks the Game for one
 * agent after the other.
 */
final class TeamPlaymaker extends TeamPlaymakerGrpc.TeamPlaymakerImplBase {
    private static final int COACH = 12;
    private static final int TRAINER = 13;
    private final Game game;

    TeamPlaymaker(Game game) {
        this.game = game;
    }

    /** Parses the message of an agent. */
    private interface Parser<T> {
        T parse(com.google.protobuf.ByteString bytes) throws InvalidProtocolBufferException;
    }

    @Override
    public void registerTeam(RegisterTeamRequest request,
                             StreamObserver<RegisterTeamResponse> reply) {
        Game.send(reply, () -> RegisterTeamResponse.newBuilder().setVersion(1)
            .addAllAgents(each(request.getAgentsList(), RegisterRequest::parseFrom,
                registration -> game.register(registration)))
            .build());
    }

    @Override
    public void getTeamActions(GetTeamActionsRequest request,
                               StreamObserver<GetTeamActionsResponse> reply) {
        Game.send(reply, () -> teamActions(request));
    }

    GetTeamActionsResponse teamActions(GetTeamActionsRequest request) {
        return GetTeamActionsResponse.newBuilder().addAllAgents(request.getAgentsList().stream()
            .map(agent -> one(agent, State::parseFrom, decision(agent.getAgent()))).toList())
            .build();
    }

    @Override
    public void getBestPlannerActions(GetBestPlannerActionsRequest request,
                                      StreamObserver<GetBestPlannerActionsResponse> reply) {
        Game.send(reply, () -> GetBestPlannerActionsResponse.newBuilder()
            .addAllAgents(each(request.getAgentsList(), BestPlannerActionRequest::parseFrom,
                game::bestPlannerAction))
            .build());
    }

    @Override
    public void unregisterTeam(UnregisterTeamRequest request,
                               StreamObserver<UnregisterTeamResponse> reply) {
        Game.send(reply, UnregisterTeamResponse::getDefaultInstance);
    }

    private Function<State, MessageLite> decision(int agent) {
        return switch (agent) {
            case COACH -> game::coachActions;
            case TRAINER -> Decide::decideAsTrainer;
            default -> Decide::decide;
        };
    }

    private static <T> List<AgentReply> each(List<AgentMessage> agents, Parser<T> parser,
                                             Function<T, MessageLite> method) {
        return agents.stream().map(agent -> one(agent, parser, method)).toList();
    }

    /** One agent's reply. What fails for one agent concerns the reply to that agent alone. */
    private static <T> AgentReply one(AgentMessage agent, Parser<T> parser,
                                      Function<T, MessageLite> method) {
        AgentReply.Builder reply = AgentReply.newBuilder().setAgent(agent.getAgent());
        Status status;
        try {
            T request = parser.parse(agent.getMessage());
            return reply.setMessage(method.apply(request).toByteString()).build();
        } catch (InvalidProtocolBufferException error) {
            status = Status.INVALID_ARGUMENT.withDescription(error.getMessage());
        } catch (RuntimeException error) {
            status = Game.status(error);
        }
        return reply.setCode(status.getCode().value())
            .setError(String.valueOf(status.getDescription())).build();
    }
}
