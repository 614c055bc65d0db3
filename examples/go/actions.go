package main

import pb "team/pb"

// Constructors of the actions that the team uses. docs/actions.md of cls describes all actions.

func vector(place Point) *pb.RpcVector2D {
	return &pb.RpcVector2D{X: float32(place.X + 0), Y: float32(place.Y + 0)} // never a negative zero
}

func beforeKickOff(place Point) *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_BhvBeforeKickOff{
		BhvBeforeKickOff: &pb.Bhv_BeforeKickOff{Point: vector(place)}}}
}

func smartKick(target Point, speed, minSpeed float64, kicks int32) *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_BodySmartKick{BodySmartKick: &pb.Body_SmartKick{
		TargetPoint: vector(target), FirstSpeed: float32(speed),
		FirstSpeedThreshold: float32(minSpeed), MaxSteps: kicks}}}
}

func dribble(target Point, dashPower float64, dashes int32) *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_BodyDribble{BodyDribble: &pb.Body_Dribble{
		TargetPoint: vector(target), DistanceThreshold: 1, DashPower: float32(dashPower),
		DashCount: dashes, Dodge: true}}}
}

func goTo(target Point, within, dashPower float64) *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_BodyGoToPoint{BodyGoToPoint: &pb.Body_GoToPoint{
		TargetPoint: vector(target), DistanceThreshold: float32(within),
		MaxDashPower: float32(dashPower)}}}
}

func intercept(face Point) *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_BodyIntercept{
		BodyIntercept: &pb.Body_Intercept{FacePoint: vector(face)}}}
}

func holdBall(face Point) *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_BodyHoldBall{BodyHoldBall: &pb.Body_HoldBall{
		DoTurn: true, TurnTargetPoint: vector(face), KickTargetPoint: vector(face)}}}
}

func clearBall() *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_BodyClearBall{BodyClearBall: &pb.Body_ClearBall{}}}
}

func turnToBall() *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_BodyTurnToBall{
		BodyTurnToBall: &pb.Body_TurnToBall{Cycle: 1}}}
}

// watchBall is for the neck: to the ball if its estimate is older than maxAge cycles, else around.
func watchBall(maxAge int32) *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_NeckTurnToBallOrScan{
		NeckTurnToBallOrScan: &pb.Neck_TurnToBallOrScan{CountThreshold: maxAge}}}
}

func watchGoalie() *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_NeckTurnToGoalieOrScan{
		NeckTurnToGoalieOrScan: &pb.Neck_TurnToGoalieOrScan{}}}
}

func shoot() *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_HeliosShoot{HeliosShoot: &pb.HeliosShoot{}}}
}

// basicMove is for players without the ball: tackle, block, mark, or move to the proxy's formation.
func basicMove() *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_HeliosBasicMove{
		HeliosBasicMove: &pb.HeliosBasicMove{}}}
}

func goalie() *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_HeliosGoalie{HeliosGoalie: &pb.HeliosGoalie{}}}
}

func setPlay() *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_HeliosSetPlay{HeliosSetPlay: &pb.HeliosSetPlay{}}}
}

func penalty() *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_HeliosPenalty{HeliosPenalty: &pb.HeliosPenalty{}}}
}

func substitute() *pb.CoachAction {
	return &pb.CoachAction{Action: &pb.CoachAction_DoHeliosSubstitute{
		DoHeliosSubstitute: &pb.DoHeliosSubstitute{}}}
}

func sayPlayerTypes() *pb.CoachAction {
	return &pb.CoachAction{Action: &pb.CoachAction_DoHeliosSayPlayerTypes{
		DoHeliosSayPlayerTypes: &pb.DoHeliosSayPlayerTypes{}}}
}

// showText is in the page of the match, tab Drawings; it moves nothing.
func showText(text string) *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_Log{Log: &pb.Log{Log: &pb.Log_AddText{
		AddText: &pb.AddText{Level: pb.LoggerLevel_TEAM, Message: text}}}}}
}

// showLine is on the field in the page of the match; it moves nothing.
func showLine(start, end Point, color string) *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_Log{Log: &pb.Log{Log: &pb.Log_AddLine{
		AddLine: &pb.AddLine{Level: pb.LoggerLevel_TEAM, Start: vector(start), End: vector(end),
			Color: color}}}}}
}

// planAttack is for the player with the ball: the best of the passes and dribbles that the proxy finds.
func planAttack() *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_HeliosOffensivePlanner{
		HeliosOffensivePlanner: &pb.HeliosOffensivePlanner{
			DirectPass: true, LeadPass: true, ThroughPass: true, ShortDribble: true,
			LongDribble: true, Cross: true, SimplePass: true, SimpleDribble: true}}}
}
