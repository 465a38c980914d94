package org.robonewbie.simulator.soccer;

import java.util.Arrays;
import java.util.Optional;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.text.Spelling;

/**
 * Parameters of the pitch, the robots, the noise and the rules, with their names in SimSpark's {@code naosoccersim.rb}
 * and their values in the league and beginners' profiles.
 *
 * <p>Source of names and league values: rcssserver3d 0.7.3. Boolean values are {@code true} or {@code false}.
 */
public enum SoccerParameter {
    /** Length of the pitch. */
    FIELD_LENGTH("FieldLength", 30, 12, "metres from goal line to goal line"),
    /** Width of the pitch. */
    FIELD_WIDTH("FieldWidth", 20, 8, "metres from side line to side line"),
    /** Height of the field. */
    FIELD_HEIGHT("FieldHeight", 40, 40, "metres, only sent to monitors"),
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
    /** Distance that opponents must keep from a set piece. */
    FREE_KICK_DISTANCE(
            "FreeKickDistance",
            2,
            1.3,
            "metres that opponents must keep from a set piece; radius of the centre circle"),
    /** Distance from a set piece to which opponents are moved. */
    FREE_KICK_MOVE_DISTANCE("FreeKickMoveDist", 2.5, 1.5, "metres from a set piece to which opponents are moved"),
    /** Distance from the ball to which the kicking team is moved when the ball is placed. */
    KICK_REPEL_DISTANCE(
            "KickRepelDist", 0.5, 0.5, "metres by which the kicking team is moved away when the ball is placed"),
    /** Distance of the goal kick from the goal line. */
    GOAL_KICK_DISTANCE("GoalKickDist", 1, 1, "metres from the goal line to the goal kick"),
    /** Width of the border around the pitch. */
    BORDER_SIZE("BorderSize", 0, 0, "metres, only sent to monitors"),
    /** Whether the match starts automatically, without a referee. */
    AUTOMATIC_KICK_OFF("AutomaticKickOff", false, true, "whether the match starts without a referee"),
    /** Time from the first agent to the automatic kick-off. */
    WAIT_BEFORE_KICK_OFF("WaitBeforeKickOff", 30, 0, "seconds from the first agent to the automatic kick-off"),
    /** Whether a coin toss decides which team has the first kick-off. */
    COIN_TOSS_FOR_KICK_OFF(
            "CoinTossForKickOff",
            false,
            false,
            "whether a coin toss decides the first kick-off; otherwise the left team has it"),
    /** Whether the match is a penalty shoot-out. */
    PENALTY_SHOOTOUT("PenaltyShootout", false, false, "whether the left team shoots at a lone goalkeeper"),
    /** Whether robots may start in the opponents' half. */
    START_ANY_FIELD_POSITION(
            "StartAnyFieldPosition", false, true, "whether robots may be beamed into the opponents' half"),
    /** Whether the simulator exits after the match. */
    AUTOMATIC_QUIT("AutomaticQuit", false, false, "whether the simulator exits ten seconds after the match"),
    /** Whether the teams change sides at half-time. */
    CHANGE_SIDES_IN_SECOND_HALF("ChangeSidesInSecondHalf", false, false, "whether the teams change sides at half-time"),
    /** Whether the game is keep-away instead of soccer. */
    KEEPAWAY("Keepaway", false, false, "whether the left team only has to keep the ball inside a shrinking area"),
    /** The x coordinate of the centre of the keep-away area. */
    KEEPAWAY_CENTER_X("KeepawayCenterX", 0, 0, "metres"),
    /** The y coordinate of the centre of the keep-away area. */
    KEEPAWAY_CENTER_Y("KeepawayCenterY", 0, 0, "metres"),
    /** Initial length of the keep-away area. */
    KEEPAWAY_LENGTH("KeepawayLength", 20, 8, "initial length (along x), metres"),
    /** Initial width of the keep-away area. */
    KEEPAWAY_WIDTH("KeepawayWidth", 20, 8, "initial width (along y), metres"),
    /** Rate at which the length of the keep-away area shrinks. */
    KEEPAWAY_LENGTH_REDUCTION_RATE("KeepawayLengthReductionRate", 4, 4, "metres per minute"),
    /** Rate at which the width of the keep-away area shrinks. */
    KEEPAWAY_WIDTH_REDUCTION_RATE("KeepawayWidthReductionRate", 4, 4, "metres per minute"),
    /** Nominal radius of a robot. */
    AGENT_RADIUS("AgentRadius", 0.4, 0.4, "metres: torso height of a beamed robot and space for a moved robot"),
    /** Maximum number of robots of one type in a team. */
    MAX_ROBOT_TYPE_COUNT("MaxRobotTypeCount", 7, 11, "maximum number of robots of one type in a team"),
    /** Minimum number of robot types in a full team. */
    MIN_ROBOT_TYPES_COUNT("MinRobotTypesCount", 3, 1, "minimum number of robot types in a full team"),
    /** Maximum number of robots of any two types in a team. */
    MAX_SUM_TWO_ROBOT_TYPES("MaxSumTwoRobotTypes", 9, 11, "maximum number of robots of any two types in a team"),
    /** Radius of the ball. */
    BALL_RADIUS("BallRadius", SoccerField.BALL_RADIUS, SoccerField.BALL_RADIUS, "metres"),
    /** Mass of the ball. */
    BALL_MASS("BallMass", 0.026, 0.026, "kilograms"),
    /** Pause after a goal. */
    RULE_GOAL_PAUSE_TIME("RuleGoalPauseTime", 3, 3, "seconds from a goal to the next kick-off"),
    /** Pause before the ball is placed for a set piece. */
    RULE_KICK_IN_PAUSE_TIME("RuleKickInPauseTime", 1, 1, "seconds until the ball is placed for a set piece"),
    /** Length of a half. */
    RULE_HALF_TIME("RuleHalfTime", 300, 1800, "length of a half, seconds"),
    /** Time limit of a set piece. */
    RULE_DROP_BALL_TIME("RuleDropBallTime", 15, 15, "seconds until the ball is dropped if the set piece is not taken"),
    /** Whether the match ends after one half. */
    SINGLE_HALF_TIME("SingleHalfTime", false, true, "whether the match ends after one half"),
    /** Whether the offside rule applies; not implemented. */
    USE_OFFSIDE("UseOffside", false, false, "without effect, as in rcssserver3d"),
    /** Maximum number of robots that may be in contact with each other. */
    MAX_TOUCH_GROUP_SIZE("MaxTouchGroupSize", 2, 1000, "maximum number of robots that may touch each other"),
    /** Whether a touching foul is penalised by removal from the pitch. */
    TOUCHING_FOUL_BEAM_PENALTY(
            "TouchingFoulBeamPenalty", false, false, "whether a touching foul removes the robot from the pitch"),
    /** Whether charging is a foul. */
    USE_CHARGING("UseCharging", true, false, "whether running into an opponent is a foul"),
    /** Minimum speed of a charging robot. */
    CHARGING_MIN_SPEED("ChargingMinSpeed", 0.4, 0.4, "metres per second"),
    /** Minimum angle between a charging robot's motion and the direction to the ball. */
    CHARGING_MIN_BALL_SPEED_ANGLE(
            "ChargingMinBallSpeedAngle", 30, 30, "degrees between the robot's motion and the ball"),
    /** Charging: minimum difference between the robots' distances from the ball. */
    CHARGING_MIN_DELTA_DISTANCE(
            "ChargingMinDeltaDist", 0.05, 0.05, "metres by which one robot is farther from the ball"),
    /** Charging: minimum difference between the angles at which the robots approach each other. */
    CHARGING_MIN_DELTA_ANGLE("ChargingMinDeltaAng", 15, 15, "degrees"),
    /** Duration of immunity from charging after a touch of the ball. */
    CHARGING_IMMUNITY_TIME("ChargingImmunityTime", 1, 1, "seconds of immunity after a touch of the ball"),
    /** Charging: time without contact after which a contact counts as a new collision. */
    CHARGING_COLLISION_MIN_TIME("ChargingCollisionMinTime", 0.2, 0.2, "seconds without contact before a new collision"),
    /**
     * Charging: maximum distance at which a robot counts as near the ball; if both robots are farther away, the ball is
     * ignored.
     */
    CHARGING_MAX_BALL_RULES_DISTANCE("ChargingMaxBallRulesDist", 1, 1, "maximum metres to the ball for the ball rules"),
    /** Charging: minimum distance of a collision from the ball. */
    CHARGING_MIN_COLLISION_BALL_DISTANCE("ChargingMinCollBallDist", 0.1, 0.1, "metres from the collision to the ball"),
    /** Charging: minimum speed of a robot towards the collision. */
    CHARGING_MIN_COLLISION_SPEED("ChargingMinCollisionSpeed", 0.2, 0.2, "metres per second towards the collision"),
    /** Overlap of two links below which there is no self-collision. */
    SELF_COLLISIONS_TOLERANCE("SelfCollisionsTolerance", 0.04, 0.04, "metres by which two links may overlap"),
    /** Whether the console reports self-collisions. */
    PRINT_SELF_COLLISIONS("PrintSelfCollisions", true, false, "whether the console reports self-collisions"),
    /** Whether a self-collision is a foul. */
    FOUL_ON_SELF_COLLISIONS("FoulOnSelfCollisions", true, false, "whether a self-collision is a foul"),
    /** Duration for which joints are frozen after a self-collision. */
    SELF_COLLISION_JOINT_FROZEN_TIME("SelfCollisionJointFrozenTime", 1, 1, "seconds for which the joints are frozen"),
    /** Duration for which joints are immune after being frozen. */
    SELF_COLLISION_JOINT_THAW_TIME("SelfCollisionJointThawTime", 2, 2, "seconds until the joints can be frozen again"),
    /** Whether a self-collision is penalised by removal from the pitch. */
    SELF_COLLISION_BEAM_PENALTY(
            "SelfCollisionBeamPenalty", false, false, "whether a self-collision removes the robot from the pitch"),
    /** Minimum time between two removals for self-collision. */
    SELF_COLLISION_BEAM_COOLDOWN_TIME(
            "SelfCollisionBeamCooldownTime", 10, 10, "seconds between two removals for self-collisions"),
    /** Whether self-collisions are written to a file; not implemented. */
    WRITE_SELF_COLLISIONS_TO_FILE(
            "WriteSelfCollisionsToFile", false, false, "without effect; self-collisions are in the recording"),
    /** Time limit for a robot that is not standing. */
    NOT_STANDING_MAX_TIME("NotStandingMaxTime", 30, 1e9, "seconds"),
    /** Time limit for a goalkeeper that is not standing. */
    GOALIE_NOT_STANDING_MAX_TIME("GoalieNotStandingMaxTime", 60, 1e9, "seconds"),
    /** Time limit for a robot that is lying on the ground. */
    GROUND_MAX_TIME("GroundMaxTime", 15, 1e9, "seconds"),
    /** Time limit for a goalkeeper that is lying on the ground. */
    GOALIE_GROUND_MAX_TIME("GoalieGroundMaxTime", 30, 1e9, "seconds"),
    /** Maximum number of defenders in their own penalty area. */
    MAX_PLAYERS_INSIDE_OWN_AREA(
            "MaxPlayersInsideOwnArea", 3, 1000, "maximum number of robots in their own penalty area"),
    /** Whether illegal defence is penalised by removal from the pitch. */
    ILLEGAL_DEFENSE_BEAM_PENALTY(
            "IllegalDefenseBeamPenalty", false, false, "whether illegal defence removes the robot from the pitch"),
    /** Crowding: distance between the ball and an opponent below which the foul is called. */
    MIN_OPPONENT_DISTANCE("MinOppDistance", 0, 0, "metres from ball to opponent below which crowding is called"),
    /** Crowding: distance that a team's second robot must keep from the ball. */
    MIN_SECOND_PLAYER_DISTANCE("Min2PlDistance", 0, 0, "metres that a team's second robot must keep from the ball"),
    /** Crowding: distance that a team's third robot must keep from the ball. */
    MIN_THIRD_PLAYER_DISTANCE("Min3PlDistance", 0, 0, "metres that a team's third robot must keep from the ball"),
    /** Duration for which a punished robot is held in the air. */
    FOUL_HOLD_TIME("FoulHoldTime", 0.5, 0.5, "seconds for which a punished robot is held in the air"),
    /** Whether perceptor messages contain the score. */
    REPORT_SCORE("ReportScore", true, true, "whether agents receive the score"),
    /** Whether a heard message contains the name of the speaker's team. */
    LABEL_MESSAGES("LabelMessages", true, true, "whether a heard message contains the speaker's team"),
    /** Maximum position error of a beam. */
    BEAM_NOISE_XY("BeamNoiseXY", 0.05, 0, "maximum position error of a beam in metres"),
    /** Maximum angle error of a beam. */
    BEAM_NOISE_ANGLE("BeamNoiseAngle", 10, 0, "maximum angle error of a beam in degrees"),
    /** Maximum number of positions that are tried when a robot is moved. */
    MAX_NUM_SAFE_REPOSITION_ATTEMPTS(
            "MaxNumSafeRepositionAttempts", 100, 100, "positions tried for a moved robot; 0 disables the search"),
    /** Pass mode: maximum speed of the ball. */
    PASS_MODE_MAX_BALL_SPEED("PassModeMaxBallSpeed", 0.05, 0.05, "metres per second"),
    /** Pass mode: maximum distance of the player from the ball. */
    PASS_MODE_MAX_BALL_DISTANCE("PassModeMaxBallDist", 0.5, 0.5, "metres"),
    /** Pass mode: minimum distance of opponents from the ball. */
    PASS_MODE_MIN_OPPONENT_BALL_DISTANCE("PassModeMinOppBallDist", 1, 1, "metres"),
    /** Pass mode: duration. */
    PASS_MODE_DURATION("PassModeDuration", 4, 4, "seconds"),
    /** Pass mode: time until the team may score again. */
    PASS_MODE_SCORE_WAIT_TIME("PassModeScoreWaitTime", 10, 10, "seconds"),
    /** Pass mode: time before a team can request it again. */
    PASS_MODE_RETRY_WAIT_TIME("PassModeRetryWaitTime", 3, 3, "seconds"),
    /** Whether the rules for indirect kicks and double touches apply; they always do in rcssserver3d. */
    FREE_KICK_RULES("FreeKickRules", true, false, "whether the rules for indirect kicks and double touches apply"),
    /** Period after joining in which a robot may be beamed during play; not in rcssserver3d. */
    BEAM_GRACE_TIME("BeamGraceTime", 0, 2, "seconds after joining in which a robot may be beamed in any play mode");

    private final String simSparkName;
    private final double leagueValue;
    private final double beginnerValue;
    private final boolean isBoolean;
    private final String description;

    SoccerParameter(String simSparkName, double leagueValue, double beginnerValue, String description) {
        this(simSparkName, leagueValue, beginnerValue, false, description);
    }

    SoccerParameter(String simSparkName, boolean leagueValue, boolean beginnerValue, String description) {
        this(simSparkName, leagueValue ? 1 : 0, beginnerValue ? 1 : 0, true, description);
    }

    SoccerParameter(
            String simSparkName, double leagueValue, double beginnerValue, boolean isBoolean, String description) {
        this.simSparkName = simSparkName;
        this.leagueValue = leagueValue;
        this.beginnerValue = beginnerValue;
        this.isBoolean = isBoolean;
        this.description = description;
    }

    /** {@return the SimSpark name, used on the command line and in files, such as {@code RuleHalfTime}} */
    public String simSparkName() {
        return simSparkName;
    }

    /** {@return a one-line description, including the unit} */
    public String description() {
        return description;
    }

    /** {@return whether the parameter is boolean} */
    public boolean isBoolean() {
        return isBoolean;
    }

    /** {@return the value in the league profile; 1 for true and 0 for false} */
    public double leagueValue() {
        return leagueValue;
    }

    /** {@return the value in the beginners' profile; 1 for true and 0 for false} */
    public double beginnerValue() {
        return beginnerValue;
    }

    /**
     * Finds a parameter.
     *
     * @param simSparkName its exact name
     * @return the parameter, if it exists
     */
    public static Optional<SoccerParameter> ofSimSparkName(String simSparkName) {
        return Arrays.stream(values())
                .filter(parameter -> parameter.simSparkName.equals(simSparkName))
                .findFirst();
    }

    /**
     * Suggests the parameter with the most similar name.
     *
     * @param name a misspelt name
     * @return a space and a sentence; see {@link Spelling#question}
     */
    public static String question(String name) {
        return Spelling.question(
                name, Arrays.stream(values()).map(SoccerParameter::simSparkName).toList());
    }
}
