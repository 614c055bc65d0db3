package team;

import io.grpc.Server;
import io.grpc.netty.shaded.io.grpc.netty.NettyServerBuilder;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.concurrent.TimeUnit;

/** Serves the team until SIGTERM or Ctrl-C: ./run --port N [--coach]. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) throws InterruptedException {
        int port = 50051;
        boolean withCoach = false;
        for (int i = 0; i < arguments.length; i++) {
            if (arguments[i].equals("--coach")) {
                withCoach = true;
            } else if (arguments[i].equals("--port") && i + 1 < arguments.length
                && arguments[i + 1].matches("\\d{1,5}")) {
                port = Integer.parseInt(arguments[++i]);
            } else {
                System.err.println("usage: run [--port N] [--coach]");
                System.exit(arguments[i].equals("--help") ? 0 : 2);
            }
        }
        Game game = new Game(withCoach);
        Server server = NettyServerBuilder.forAddress(new InetSocketAddress("127.0.0.1", port))
            .addService(game).addService(new TeamPlaymaker(game)).build();
        try {
            server.start();
        } catch (IOException error) {
            System.err.println(error.getMessage() + ": " + error.getCause());
            System.exit(1);
        }
        System.out.println("listening on 127.0.0.1:" + server.getPort());
        Runtime.getRuntime().addShutdownHook(new Thread(() -> stop(server)));
        server.awaitTermination();
    }

    private static void stop(Server server) {
        server.shutdown();
        try {
            server.awaitTermination(1, TimeUnit.SECONDS); // calls in flight
        } catch (InterruptedException error) {
            Thread.currentThread().interrupt();
        }
        server.shutdownNow();
    }
}
