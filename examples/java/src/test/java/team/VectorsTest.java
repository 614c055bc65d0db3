package team;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import cls.playmaker.v1.TeamPlaymakerOuterClass.AgentReply;
import cls.playmaker.v1.TeamPlaymakerOuterClass.GetTeamActionsRequest;
import cls.playmaker.v1.TeamPlaymakerOuterClass.GetTeamActionsResponse;
import com.google.protobuf.Message;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import protos.Playmaker.CoachActions;
import protos.Playmaker.PlayerActions;
import protos.Playmaker.TrainerActions;

/** The same replies as the teams in other languages: fixtures/team, written by examples/vectors.py. */
class VectorsTest {
    private static final Path FOLDER = Path.of("../../fixtures/team");

    @Test
    void repliesToRecordedStates() throws IOException {
        var request =
            GetTeamActionsRequest.parseFrom(Files.readAllBytes(FOLDER.resolve("states.bin")));
        var expected =
            GetTeamActionsResponse.parseFrom(Files.readAllBytes(FOLDER.resolve("replies.bin")));
        var actual = new TeamPlaymaker(new Game(true)).teamActions(request);
        assertTrue(expected.getAgentsCount() > 50);
        assertEquals(expected.getAgentsCount(), actual.getAgentsCount());
        for (int i = 0; i < expected.getAgentsCount(); i++) {
            assertEquals(parsed(expected.getAgents(i)), parsed(actual.getAgents(i)), "State " + i);
        }
    }

    private static Message parsed(AgentReply reply) throws IOException {
        assertEquals(0, reply.getCode(), reply.getError());
        return switch (reply.getAgent()) {
            case 12 -> CoachActions.parseFrom(reply.getMessage());
            case 13 -> TrainerActions.parseFrom(reply.getMessage());
            default -> PlayerActions.parseFrom(reply.getMessage());
        };
    }
}
