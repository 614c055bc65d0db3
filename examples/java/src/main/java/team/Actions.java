package team;

import protos.Playmaker.*;

/** Constructors of the actions that the team uses. docs/actions.md of cls describes all actions. */
final class Actions {
    private Actions() {}

    private static RpcVector2D vector(Point place) { // + 0.0: never a negative zero
        return RpcVector2D.newBuilder()
            .setX((float) (place.x() + 0.0)).setY((float) (place.y() + 0.0)).build();
    }

    static PlayerAction beforeKickOff(Point place) {
        return PlayerAction.newBuilder().setBhvBeforeKickOff(
            Bhv_BeforeKickOff.newBuilder().setPoint(vector(place))).build();
    }

    static PlayerAction smartKick(Point target, double speed, double minSpeed, int kicks) {
        return PlayerAction.newBuilder().setBodySmartKick(Body_SmartKick.newBuilder()
            .setTargetPoint(vector(target)).setFirstSpeed((float) speed)
            .setFirstSpeedThreshold((float) minSpeed).setMaxSteps(kicks)).build();
    }

    static PlayerAction dribble(Point target, double dashPower, int dashes) {
        return PlayerAction.newBuilder().setBodyDribble(Body_Dribble.newBuilder()
            .setTargetPoint(vector(target)).setDistanceThreshold(1).setDashPower((float) dashPower)
            .setDashCount(dashes).setDodge(true)).build();
    }

    static PlayerAction goTo(Point target, double within, double dashPower) {
        return PlayerAction.newBuilder().setBodyGoToPoint(Body_GoToPoint.newBuilder()
            .setTargetPoint(vector(target)).setDistanceThreshold((float) within)
            .setMaxDashPower((float) dashPower)).build();
    }

    static PlayerAction intercept(Point face) {
        return PlayerAction.newBuilder().setBodyIntercept(
            Body_Intercept.newBuilder().setFacePoint(vector(face))).build();
    }

    static PlayerAction holdBall(Point face) {
        return PlayerAction.newBuilder().setBodyHoldBall(Body_HoldBall.newBuilder().setDoTurn(true)
            .setTurnTargetPoint(vector(face)).setKickTargetPoint(vector(face))).build();
    }

    static PlayerAction clearBall() {
        return PlayerAction.newBuilder().setBodyClearBall(Body_ClearBall.newBuilder()).build();
    }

    static PlayerAction turnToBall() {
        return PlayerAction.newBuilder().setBodyTurnToBall(
            Body_TurnToBall.newBuilder().setCycle(1)).build();
    }

    /** The neck: to the ball if its estimate is older than maxAge cycles, else around. */
    static PlayerAction watchBall(int maxAge) {
        return PlayerAction.newBuilder().setNeckTurnToBallOrScan(
            Neck_TurnToBallOrScan.newBuilder().setCountThreshold(maxAge)).build();
    }

    static PlayerAction watchGoalie() {
        return PlayerAction.newBuilder().setNeckTurnToGoalieOrScan(
            Neck_TurnToGoalieOrScan.newBuilder()).build();
    }

    static PlayerAction shoot() {
        return PlayerAction.newBuilder().setHeliosShoot(HeliosShoot.newBuilder()).build();
    }

    /** Without the ball: tackle, block, mark, or move to the proxy's own formation. */
    static PlayerAction basicMove() {
        return PlayerAction.newBuilder().setHeliosBasicMove(HeliosBasicMove.newBuilder()).build();
    }

    static PlayerAction goalie() {
        return PlayerAction.newBuilder().setHeliosGoalie(HeliosGoalie.newBuilder()).build();
    }

    static PlayerAction setPlay() {
        return PlayerAction.newBuilder().setHeliosSetPlay(HeliosSetPlay.newBuilder()).build();
    }

    static PlayerAction penalty() {
        return PlayerAction.newBuilder().setHeliosPenalty(HeliosPenalty.newBuilder()).build();
    }

    static CoachAction substitute() {
        return CoachAction.newBuilder().setDoHeliosSubstitute(
            DoHeliosSubstitute.newBuilder()).build();
    }

    static CoachAction sayPlayerTypes() {
        return CoachAction.newBuilder().setDoHeliosSayPlayerTypes(
            DoHeliosSayPlayerTypes.newBuilder()).build();
    }

    /** In the page of the match, tab Drawings; moves nothing. */
    static PlayerAction showText(String text) {
        return PlayerAction.newBuilder().setLog(Log.newBuilder().setAddText(
            AddText.newBuilder().setLevel(LoggerLevel.TEAM).setMessage(text))).build();
    }

    /** On the field in the page of the match; moves nothing. */
    static PlayerAction showLine(Point start, Point end, String color) {
        return PlayerAction.newBuilder().setLog(Log.newBuilder().setAddLine(
            AddLine.newBuilder().setLevel(LoggerLevel.TEAM).setStart(vector(start))
                .setEnd(vector(end)).setColor(color))).build();
    }

    /** With the ball: the best of the passes and dribbles that the proxy finds. */
    static PlayerAction planAttack() {
        return PlayerAction.newBuilder().setHeliosOffensivePlanner(
            HeliosOffensivePlanner.newBuilder()
                .setDirectPass(true).setLeadPass(true).setThroughPass(true).setShortDribble(true)
                .setLongDribble(true).setCross(true).setSimplePass(true)
                .setSimpleDribble(true)).build();
    }
}
