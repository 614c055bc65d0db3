// The same replies as the teams in other languages: fixtures/team, written by examples/vectors.py.
// A program without packages of its own; a test program of xunit.v3 would start in the same way.
using Cls.Playmaker.V1;
using Google.Protobuf;
using Protos;
using Team;

const string Folder = "../../fixtures/team";
var request = GetTeamActionsRequest.Parser.ParseFrom(Read("states.bin"));
var expected = GetTeamActionsResponse.Parser.ParseFrom(Read("replies.bin")).Agents;
var actual = new TeamService(new Playmaker(withCoach: true)).TeamActions(request).Agents;
var failures = 0;
Check(expected.Count > 50 && expected.Count == actual.Count, $"{actual.Count} replies to {expected.Count} States");
for (var index = 0; index < Math.Min(actual.Count, expected.Count); index++)
{
    var (reply, recorded) = (actual[index], expected[index]);
    Check(reply.Code == 0, $"State {index}: {reply.Error}");
    Check(reply.Agent == recorded.Agent && Parsed(reply).Equals(Parsed(recorded)),
        $"State {index}: {Parsed(reply)} instead of {Parsed(recorded)}");
}
Console.WriteLine($"{actual.Count} States, {failures} failures");
return failures == 0 ? 0 : 1;

static byte[] Read(string name) => File.ReadAllBytes(Path.Combine(Folder, name));

static IMessage Parsed(AgentReply reply) => reply.Agent switch
{
    12 => CoachActions.Parser.ParseFrom(reply.Message),
    13 => TrainerActions.Parser.ParseFrom(reply.Message),
    _ => PlayerActions.Parser.ParseFrom(reply.Message),
};

void Check(bool holds, string otherwise)
{
    if (holds) return;
    failures++;
    Console.Error.WriteLine(otherwise);
}
