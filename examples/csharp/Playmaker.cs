// What both services reply with: one method per call that is not empty.
using System.Diagnostics;
using Grpc.Core;
using Grpc.Core.Interceptors;
using Protos;

namespace Team;

public sealed class Playmaker(bool withCoach)
{
    public RegisterResponse Register(RegisterRequest request) => new()
    {
        ClientId = request.UniformNumber,
        AgentType = request.AgentType,
        TeamName = request.TeamName,
        UniformNumber = request.UniformNumber,
        RpcServerLanguageType = RpcServerLanguageType.Csharp,
    };

    public PlayerActions PlayerActions(State state) => Decide.AsPlayer(state);

    public CoachActions CoachActions(State state)
    {
        if (!withCoach)
        {
            throw new RpcException(new(StatusCode.Unimplemented, "started without --coach"));
        }
        return Decide.AsCoach(state);
    }

    public TrainerActions TrainerActions(State state) => Decide.AsTrainer(state);

    /// <summary>The node with the highest value; the lowest index among equal ones.</summary>
    public BestPlannerActionResponse BestPlannerAction(BestPlannerActionRequest request) => new()
    {
        Index = request.Pairs.OrderByDescending(node => node.Value.Evaluation)
            .ThenBy(node => node.Key).Select(node => node.Key).FirstOrDefault(-1),
    };
}

/// <summary>Exceptions of a decision as the status of its call.</summary>
public sealed class Failures : Interceptor
{
    /// <summary>Names type, message and line; the log has the stack.</summary>
    public static Status StatusOf(Exception error)
    {
        if (error is RpcException chosen) return chosen.Status;
        Console.Error.WriteLine(error);
        var place = new StackTrace(error, fNeedFileInfo: true).GetFrames()
            .FirstOrDefault(frame => frame.GetFileName() is not null);
        var line = place is null
            ? "" : $" ({Path.GetFileName(place.GetFileName())}:{place.GetFileLineNumber()})";
        return new(StatusCode.Unknown, $"{error.GetType().Name}: {error.Message}{line}");
    }

    public override async Task<TResponse> UnaryServerHandler<TRequest, TResponse>(
        TRequest request, ServerCallContext context,
        UnaryServerMethod<TRequest, TResponse> continuation)
    {
        try
        {
            return await continuation(request, context);
        }
        catch (Exception error)
        {
            throw new RpcException(StatusOf(error));
        }
    }
}
