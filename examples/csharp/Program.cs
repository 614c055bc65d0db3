// Serves the team until SIGTERM or Ctrl-C: ./run --port N [--coach]
using System.Net;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using Team;

var port = 50051;
var withCoach = false;
for (var i = 0; i < args.Length; i++)
{
    if (args[i] == "--coach")
    {
        withCoach = true;
    }
    else if (args[i] == "--port" && i + 1 < args.Length && ushort.TryParse(args[i + 1], out var number))
    {
        port = number;
        i++;
    }
    else
    {
        Console.Error.WriteLine("usage: run [--port N] [--coach]");
        return args[i] == "--help" ? 0 : 2;
    }
}

// There are no settings to watch: each watch takes one of the few inotify instances of a user.
Environment.SetEnvironmentVariable("DOTNET_hostBuilder__reloadConfigOnChange", "false");
var builder = WebApplication.CreateSlimBuilder();
builder.Logging.SetMinimumLevel(LogLevel.Warning).AddFilter("Microsoft.Extensions.Hosting", LogLevel.None);
builder.Services.AddGrpc(options => options.Interceptors.Add<Failures>());
builder.Services.AddSingleton(new Playmaker(withCoach))
    .AddSingleton<Failures>().AddSingleton<GameService>().AddSingleton<TeamService>()
    .Configure<HostOptions>(options => options.ShutdownTimeout = TimeSpan.FromSeconds(1)); // calls in flight
builder.WebHost.ConfigureKestrel(options =>
{
    options.Listen(IPAddress.Loopback, port, listen => listen.Protocols = HttpProtocols.Http2);
    options.Limits.Http2.InitialConnectionWindowSize = 1 << 20; // a State is larger than the default
    options.Limits.Http2.InitialStreamWindowSize = 1 << 20;
});

await using var app = builder.Build();
app.MapGrpcService<GameService>();
app.MapGrpcService<TeamService>();
try
{
    await app.StartAsync();
}
catch (IOException error)
{
    Console.Error.WriteLine($"run: {error.Message}");
    return 1;
}
Console.WriteLine($"listening on 127.0.0.1:{new Uri(app.Urls.First()).Port}");
await app.WaitForShutdownAsync();
return 0;
