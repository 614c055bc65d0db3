// Bits of a player's state in a game log (docs/spec/log-formats.md 1.3).

export const PlayerState = Object.freeze({
  enabled: 0x1,
  kick: 0x2,
  kickFailed: 0x4,
  goalie: 0x8,
  catch: 0x10,
  catchFailed: 0x20,
  tackle: 0x1000,
  tackleFailed: 0x2000,
  backPass: 0x4000,
  freeKickFault: 0x8000,
  charged: 0x20000,
  yellowCard: 0x40000,
  redCard: 0x80000,
  illegalDefense: 0x100000,
});
