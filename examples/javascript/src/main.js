// Serves the team until SIGTERM or Ctrl-C: ./run --port N [--coach]
import grpc from '@grpc/grpc-js';
import { parseArgs } from 'node:util';
import { game, gameMethods, handlers, team, teamMethods } from './service.js';

const GRACE = 1000; // ms for calls in flight

const { values } = parseArgs({
  options: { port: { type: 'string', default: '50051' }, coach: { type: 'boolean', default: false } },
});
const methods = gameMethods(values.coach);
const server = new grpc.Server();
server.addService(game, handlers(methods));
server.addService(team, handlers(teamMethods(methods)));
server.bindAsync(`127.0.0.1:${values.port}`, grpc.ServerCredentials.createInsecure(), (error, port) => {
  if (error) {
    console.error(error.message);
    process.exit(1);
  }
  console.log(`listening on 127.0.0.1:${port}`);
});
for (const signal of ['SIGTERM', 'SIGINT']) {
  process.on(signal, () => {
    setTimeout(() => process.exit(0), GRACE).unref();
    server.tryShutdown(() => process.exit(0));
  });
}
