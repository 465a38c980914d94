package org.robonewbie.simulator.soccer;

import static org.assertj.core.api.Assertions.assertThat;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld;
import org.robonewbie.simulator.world.BallProperties;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** A game on the real pitch for tests of the rules: robots stand where they are put. */
final class Game {

    static final double STANDING_HEIGHT = 0.4;

    final SoccerWorld world;
    final Match match;

    Game(SoccerParameters parameters) {
        this(parameters, 1);
    }

    Game(SoccerParameters parameters, String... assignments) {
        this(changed(parameters, assignments), 1);
    }

    Game(SoccerParameters parameters, long seed) {
        BallProperties ball = new BallProperties(
                parameters.get(SoccerParameter.BALL_RADIUS), parameters.get(SoccerParameter.BALL_MASS));
        world = new SoccerWorld(parameters.field(), ball, new SparsePhysicsWorld(), Landscape.SOCCER);
        match = new Match(world, parameters, seed);
    }

    private static SoccerParameters changed(SoccerParameters parameters, String... assignments) {
        SoccerParameters changed = parameters;
        for (String assignment : assignments) {
            changed = changed.with(assignment);
        }
        return changed;
    }

    Player join(String team, int number) {
        return join(team, number, RobotType.TYPE_0);
    }

    Player join(String team, int number, RobotType type) {
        try {
            return match.teams().join(team, number, world.addRobot(type));
        } catch (JoinRefusedException e) {
            throw new AssertionError(e);
        }
    }

    /** Puts a robot somewhere, looking along x. */
    void put(Player player, double x, double y) {
        player.robot().moveUpright(new Vector3(x, y, STANDING_HEIGHT), -90);
        player.robot().moveUpright(new Vector3(x, y, STANDING_HEIGHT), -90);
    }

    void cycle() {
        world.step();
        match.tick();
    }

    void cycles(double seconds) {
        for (int i = 0; i < Math.round(seconds * 50); i++) {
            cycle();
        }
    }

    /** Adds a robot of the left team that has fallen on its back while nothing was judged. */
    Player lying(int number) {
        Player player = join("Stars", number);
        put(player, -5, 2);
        PlayMode mode = playMode();
        match.setPlayMode(PlayMode.BEFORE_KICK_OFF);
        for (int i = 0; i < 150; i++) {
            player.robot().setMotorSpeed(Joint.LEFT_FOOT_PITCH, -3);
            player.robot().setMotorSpeed(Joint.RIGHT_FOOT_PITCH, -3);
            cycle();
        }
        match.setPlayMode(mode);
        assertThat(player.position().z()).isLessThan(0.15);
        return player;
    }

    /** Adds a robot of the left team that presses an arm against its body until the referee calls it, or for 2 seconds. */
    Player hittingItself() {
        Player player = join("Stars", 2);
        put(player, -5, 2);
        cycles(0.5);
        for (int i = 0; i < 100 && match.fouls().isEmpty(); i++) {
            bendArm(player);
            cycle();
        }
        return player;
    }

    static void bendArm(Player player) {
        turn(player, Joint.RIGHT_SHOULDER_PITCH, -81);
        turn(player, Joint.RIGHT_ARM_ROLL, -52);
        turn(player, Joint.RIGHT_ARM_YAW, 76);
    }

    static void turn(Player player, Joint joint, double degrees) {
        player.robot().setMotorSpeed(joint, 0.1 * (degrees - player.robot().jointDegrees(joint)));
    }

    /** Lets a player touch the ball: its foot is put beside the ball and then the ball into the foot. */
    void touch(Player player) {
        Robot robot = player.robot();
        Vector3 ball = world.ball().position();
        put(player, ball.x() - 0.13, ball.y() + 0.055);
        int foot = robot.nao().linkIndex("rfoot");
        world.step();
        world.ball().place(robot.linkPose(foot).position().plus(new Vector3(0.1, 0, 0.02)));
        for (int i = 0; i < 3; i++) {
            cycle();
        }
    }

    /** Lets a player touch the ball and puts it out of the way. */
    void touchAndLeave(Player player) {
        touch(player);
        put(player, player.side() == TeamSide.LEFT ? -5 : 5, 5);
    }

    /** Returns the distance of the ball from a point on the ground in metres. */
    double ballDistance(double x, double y) {
        return Math.hypot(
                world.ball().position().x() - x, world.ball().position().y() - y);
    }

    void roll(double x, double y, double speedX, double speedY) {
        world.ball().moveTo(new Vector3(x, y, world.ball().properties().radius()));
        world.ball().setVelocity(new Vector3(speedX, speedY, 0));
    }

    PlayMode playMode() {
        return match.state().playMode();
    }

    int score(TeamSide side) {
        return match.state().score(side);
    }
}
