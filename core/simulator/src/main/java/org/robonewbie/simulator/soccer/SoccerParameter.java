package org.robonewbie.simulator.soccer;

import java.util.Arrays;
import java.util.Optional;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.text.Spelling;

/**
 * Everything that can be set about pitch, robots, noise and rules, under the names of SimSpark's
 * {@code naosoccersim.rb}, each with its value in the league and in the beginners' profile.
 *
 * <p>Source of names and league values: rcssserver3d 0.7.3. Yes or no is written {@code true} or {@code false}.
 */
public enum SoccerParameter {
    /** Length of the pitch. */
    FIELD_LENGTH("FieldLength", 30, 12, "metres from goal line to goal line"),
    /** Width of the pitch. */
    FIELD_WIDTH("FieldWidth", 20, 8, "metres from side line to side line"),
    /** Height of the hall. */
    FIELD_HEIGHT("FieldHeight", 40, 40, "metres, sent to monitors only"),
    /** Width of the goal. */
    GOAL_WIDTH("GoalWidth", 2.1, 1.4, "metres between the posts"),
    /** Depth of the goal. */
    GOAL_DEPTH("GoalDepth", 0.6, 0.4, "metres from the goal line to the back wall"),
    /** Height of the goal. */
    GOAL_HEIGHT("GoalHeight", 0.8, 0.8, "metres"),
    /** Depth of the penalty area. */
    PENALTY_LENGTH("PenaltyLength", 1.8, 1.2, "depth of the penalty area, metres"),
    /** Width of the penalty area. */
    PENALTY_WIDTH("PenaltyWidth", 3.9, 2.6, "width of the penalty area without the goal's width, metres"),
    /** Free space around a free kick. */
    FREE_KICK_DISTANCE(
            "FreeKickDistance", 2, 1.3, "metres that opponents keep from a kick; radius of the centre circle"),
    /** Where opponents are put at a free kick. */
    FREE_KICK_MOVE_DISTANCE("FreeKickMoveDist", 2.5, 1.5, "metres from a kick to which opponents are moved"),
    /** How far the kicking team is pushed from the ball. */
    KICK_REPEL_DISTANCE(
            "KickRepelDist", 0.5, 0.5, "metres that the kicking team is moved away when the ball is placed"),
    /** Place of the goal kick. */
    GOAL_KICK_DISTANCE("GoalKickDist", 1, 1, "metres from the goal line to the place of a goal kick"),
    /** Strip around the pitch. */
    BORDER_SIZE("BorderSize", 0, 0, "metres, sent to monitors only"),
    /** Kick-off without a human referee. */
    AUTOMATIC_KICK_OFF("AutomaticKickOff", false, true, "whether the game begins without a human referee"),
    /** Time before the automatic kick-off. */
    WAIT_BEFORE_KICK_OFF("WaitBeforeKickOff", 30, 0, "seconds from the first agent to the automatic kick-off"),
    /** Coin for the first kick-off. */
    COIN_TOSS_FOR_KICK_OFF(
            "CoinTossForKickOff", false, false, "whether chance, not the left team, has the first kick-off"),
    /** Penalty shoot-out. */
    PENALTY_SHOOTOUT("PenaltyShootout", false, false, "whether the left team shoots at a lone goalkeeper"),
    /** Robots may start anywhere. */
    START_ANY_FIELD_POSITION("StartAnyFieldPosition", false, true, "whether robots may be beamed into the other half"),
    /** End of the program after the game. */
    AUTOMATIC_QUIT("AutomaticQuit", false, false, "whether the simulator ends ten seconds after the game"),
    /** Change of sides at half time. */
    CHANGE_SIDES_IN_SECOND_HALF("ChangeSidesInSecondHalf", false, false, "whether the teams change sides at half time"),
    /** Keep-away instead of soccer. */
    KEEPAWAY("Keepaway", false, false, "whether the left team only has to keep the ball within a shrinking area"),
    /** Centre of the keep-away area. */
    KEEPAWAY_CENTER_X("KeepawayCenterX", 0, 0, "metres"),
    /** Centre of the keep-away area. */
    KEEPAWAY_CENTER_Y("KeepawayCenterY", 0, 0, "metres"),
    /** Size of the keep-away area. */
    KEEPAWAY_LENGTH("KeepawayLength", 20, 8, "metres along x at the start"),
    /** Size of the keep-away area. */
    KEEPAWAY_WIDTH("KeepawayWidth", 20, 8, "metres along y at the start"),
    /** Shrinking of the keep-away area. */
    KEEPAWAY_LENGTH_REDUCTION_RATE("KeepawayLengthReductionRate", 4, 4, "metres per minute"),
    /** Shrinking of the keep-away area. */
    KEEPAWAY_WIDTH_REDUCTION_RATE("KeepawayWidthReductionRate", 4, 4, "metres per minute"),
    /** Room of a robot. */
    AGENT_RADIUS("AgentRadius", 0.4, 0.4, "metres: height of a beamed torso and room that a moved robot needs"),
    /** Limit of equal robots. */
    MAX_ROBOT_TYPE_COUNT("MaxRobotTypeCount", 7, 11, "robots of one type that a team may have"),
    /** Least variety of robots. */
    MIN_ROBOT_TYPES_COUNT("MinRobotTypesCount", 3, 1, "types that a team of eleven must have at least"),
    /** Limit of two types together. */
    MAX_SUM_TWO_ROBOT_TYPES("MaxSumTwoRobotTypes", 9, 11, "robots that any two types may have together"),
    /** Size of the ball. */
    BALL_RADIUS("BallRadius", SoccerField.BALL_RADIUS, SoccerField.BALL_RADIUS, "metres"),
    /** Mass of the ball. */
    BALL_MASS("BallMass", 0.026, 0.026, "kilograms"),
    /** Time to be happy about a goal. */
    RULE_GOAL_PAUSE_TIME("RuleGoalPauseTime", 3, 3, "seconds from a goal to the next kick-off"),
    /** Time before the ball is put to its place. */
    RULE_KICK_IN_PAUSE_TIME("RuleKickInPauseTime", 1, 1, "seconds until the ball is put to the place of a kick"),
    /** Length of a half. */
    RULE_HALF_TIME("RuleHalfTime", 300, 1800, "seconds of a half"),
    /** Time for a kick. */
    RULE_DROP_BALL_TIME("RuleDropBallTime", 15, 15, "seconds until a ball that nobody kicks is free for all"),
    /** Only one half. */
    SINGLE_HALF_TIME("SingleHalfTime", false, true, "whether the game ends after one half"),
    /** Offside. */
    USE_OFFSIDE("UseOffside", false, false, "without effect, as in the original"),
    /** Limit of robots that touch each other. */
    MAX_TOUCH_GROUP_SIZE("MaxTouchGroupSize", 2, 1000, "robots that may touch each other at a time"),
    /** Penalty for touching. */
    TOUCHING_FOUL_BEAM_PENALTY("TouchingFoulBeamPenalty", false, false, "whether touching puts a robot off the pitch"),
    /** Charging is a foul. */
    USE_CHARGING("UseCharging", true, false, "whether to run into an opponent is a foul"),
    /** Speed of a charging robot. */
    CHARGING_MIN_SPEED("ChargingMinSpeed", 0.4, 0.4, "metres per second"),
    /** Direction of a charging robot. */
    CHARGING_MIN_BALL_SPEED_ANGLE("ChargingMinBallSpeedAngle", 30, 30, "degrees between its way and the ball"),
    /** Difference of two robots' ways. */
    CHARGING_MIN_DELTA_DISTANCE("ChargingMinDeltaDist", 0.05, 0.05, "metres by which one is farther from the ball"),
    /** Difference of two robots' directions. */
    CHARGING_MIN_DELTA_ANGLE("ChargingMinDeltaAng", 15, 15, "degrees"),
    /** Protection of who has the ball. */
    CHARGING_IMMUNITY_TIME("ChargingImmunityTime", 1, 1, "seconds after a touch of the ball without charging"),
    /** Time between two collisions. */
    CHARGING_COLLISION_MIN_TIME("ChargingCollisionMinTime", 0.2, 0.2, "seconds without contact before a new collision"),
    /** Range of the ball rules. */
    CHARGING_MAX_BALL_RULES_DISTANCE("ChargingMaxBallRulesDist", 1, 1, "metres to the ball"),
    /** Collisions at the ball. */
    CHARGING_MIN_COLLISION_BALL_DISTANCE("ChargingMinCollBallDist", 0.1, 0.1, "metres from collision to ball"),
    /** Speed of a collision. */
    CHARGING_MIN_COLLISION_SPEED("ChargingMinCollisionSpeed", 0.2, 0.2, "metres per second towards the collision"),
    /** Tolerance of self-collisions. */
    SELF_COLLISIONS_TOLERANCE("SelfCollisionsTolerance", 0.04, 0.04, "metres that two links may overlap"),
    /** Report of self-collisions. */
    PRINT_SELF_COLLISIONS("PrintSelfCollisions", true, false, "whether the console reports self-collisions"),
    /** Self-collision is a foul. */
    FOUL_ON_SELF_COLLISIONS("FoulOnSelfCollisions", true, false, "whether a robot that hits itself is punished"),
    /** Penalty for self-collision. */
    SELF_COLLISION_JOINT_FROZEN_TIME("SelfCollisionJointFrozenTime", 1, 1, "seconds that the joints stand still"),
    /** Pause after that penalty. */
    SELF_COLLISION_JOINT_THAW_TIME("SelfCollisionJointThawTime", 2, 2, "seconds until the joints can freeze again"),
    /** Penalty for self-collision. */
    SELF_COLLISION_BEAM_PENALTY("SelfCollisionBeamPenalty", false, false, "whether it puts a robot off the pitch"),
    /** Pause after that penalty. */
    SELF_COLLISION_BEAM_COOLDOWN_TIME("SelfCollisionBeamCooldownTime", 10, 10, "seconds between two such penalties"),
    /** List of self-collisions. */
    WRITE_SELF_COLLISIONS_TO_FILE(
            "WriteSelfCollisionsToFile", false, false, "without effect: they are in the recording"),
    /** Limit for a robot that does not stand. */
    NOT_STANDING_MAX_TIME("NotStandingMaxTime", 30, 1e9, "seconds"),
    /** Limit for a goalkeeper that does not stand. */
    GOALIE_NOT_STANDING_MAX_TIME("GoalieNotStandingMaxTime", 60, 1e9, "seconds"),
    /** Limit for a robot that lies. */
    GROUND_MAX_TIME("GroundMaxTime", 15, 1e9, "seconds"),
    /** Limit for a goalkeeper that lies. */
    GOALIE_GROUND_MAX_TIME("GoalieGroundMaxTime", 30, 1e9, "seconds"),
    /** Limit of defenders. */
    MAX_PLAYERS_INSIDE_OWN_AREA("MaxPlayersInsideOwnArea", 3, 1000, "robots in their own penalty area"),
    /** Penalty for illegal defence. */
    ILLEGAL_DEFENSE_BEAM_PENALTY("IllegalDefenseBeamPenalty", false, false, "whether it puts a robot off the pitch"),
    /** Crowding: the opponent. */
    MIN_OPPONENT_DISTANCE("MinOppDistance", 0, 0, "metres from ball to opponent below which crowding is judged"),
    /** Crowding: the second robot. */
    MIN_SECOND_PLAYER_DISTANCE("Min2PlDistance", 0, 0, "metres that a team's second robot keeps from the ball"),
    /** Crowding: the third robot. */
    MIN_THIRD_PLAYER_DISTANCE("Min3PlDistance", 0, 0, "metres that a team's third robot keeps from the ball"),
    /** Time in the referee's hand. */
    FOUL_HOLD_TIME("FoulHoldTime", 0.5, 0.5, "seconds that a punished robot is held in the air"),
    /** Score in messages. */
    REPORT_SCORE("ReportScore", true, true, "whether agents receive the score"),
    /** Team names in heard messages. */
    LABEL_MESSAGES("LabelMessages", true, true, "whether a heard message names the team of the speaker"),
    /** Noise of a beam. */
    BEAM_NOISE_XY("BeamNoiseXY", 0.05, 0, "metres by which a beamed robot misses its place at most"),
    /** Noise of a beam. */
    BEAM_NOISE_ANGLE("BeamNoiseAngle", 10, 0, "degrees by which a beamed robot misses its direction at most"),
    /** Search for a free place. */
    MAX_NUM_SAFE_REPOSITION_ATTEMPTS(
            "MaxNumSafeRepositionAttempts", 100, 100, "places tried for a moved robot; 0: none"),
    /** Pass mode: speed of the ball. */
    PASS_MODE_MAX_BALL_SPEED("PassModeMaxBallSpeed", 0.05, 0.05, "metres per second"),
    /** Pass mode: distance of the player. */
    PASS_MODE_MAX_BALL_DISTANCE("PassModeMaxBallDist", 0.5, 0.5, "metres"),
    /** Pass mode: distance of opponents. */
    PASS_MODE_MIN_OPPONENT_BALL_DISTANCE("PassModeMinOppBallDist", 1, 1, "metres"),
    /** Pass mode: its length. */
    PASS_MODE_DURATION("PassModeDuration", 4, 4, "seconds"),
    /** Pass mode: no goal after it. */
    PASS_MODE_SCORE_WAIT_TIME("PassModeScoreWaitTime", 10, 10, "seconds"),
    /** Pass mode: time to the next. */
    PASS_MODE_RETRY_WAIT_TIME("PassModeRetryWaitTime", 3, 3, "seconds"),
    /** Restrictions of who takes a kick; always on in the original. */
    FREE_KICK_RULES(
            "FreeKickRules", true, false, "whether a kicker must neither score at once nor touch the ball twice"),
    /** Time in which a new robot may be beamed while the game runs; not in the original. */
    BEAM_GRACE_TIME("BeamGraceTime", 0, 2, "seconds after joining in which a robot may be beamed in every play mode");

    private final String simSparkName;
    private final double leagueValue;
    private final double beginnerValue;
    private final boolean yesOrNo;
    private final String description;

    SoccerParameter(String simSparkName, double leagueValue, double beginnerValue, String description) {
        this(simSparkName, leagueValue, beginnerValue, false, description);
    }

    SoccerParameter(String simSparkName, boolean leagueValue, boolean beginnerValue, String description) {
        this(simSparkName, leagueValue ? 1 : 0, beginnerValue ? 1 : 0, true, description);
    }

    SoccerParameter(
            String simSparkName, double leagueValue, double beginnerValue, boolean yesOrNo, String description) {
        this.simSparkName = simSparkName;
        this.leagueValue = leagueValue;
        this.beginnerValue = beginnerValue;
        this.yesOrNo = yesOrNo;
        this.description = description;
    }

    /** {@return SimSpark's name of the parameter, as on the command line and in files, such as {@code RuleHalfTime}} */
    public String simSparkName() {
        return simSparkName;
    }

    /** {@return the meaning of the parameter in one line, with the unit} */
    public String description() {
        return description;
    }

    /** {@return whether the value is yes or no instead of a number} */
    public boolean isYesOrNo() {
        return yesOrNo;
    }

    /** {@return the value in the league's profile; 1 for yes and 0 for no} */
    public double leagueValue() {
        return leagueValue;
    }

    /** {@return the value in the beginners' profile; 1 for yes and 0 for no} */
    public double beginnerValue() {
        return beginnerValue;
    }

    /**
     * Finds a parameter by its name.
     *
     * @param simSparkName the exact name
     * @return the parameter, or empty if there is none
     */
    public static Optional<SoccerParameter> ofSimSparkName(String simSparkName) {
        return Arrays.stream(values())
                .filter(parameter -> parameter.simSparkName.equals(simSparkName))
                .findFirst();
    }

    /**
     * Asks for the parameter whose name is most like a misspelt one.
     *
     * @param name what was written
     * @return a blank and a sentence, as {@link Spelling#question} writes it
     */
    public static String question(String name) {
        return Spelling.question(
                name, Arrays.stream(values()).map(SoccerParameter::simSparkName).toList());
    }
}
