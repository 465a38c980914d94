package org.robonewbie.studio;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.physics.Pose;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** A simulation of the real world with robots that hold a posture instead of being steered by agents. */
final class SmallSimulation implements SimulationControl, AutoCloseable {

    private static final long PATIENCE_SECONDS = 120;
    private static final double STANDING_HEIGHT = 0.366;
    private static final double SPEED_PER_DEGREE = 0.12;

    private final SoccerWorld world = new SoccerWorld(SoccerField.BEGINNER);
    private final List<Member> members = new CopyOnWriteArrayList<>();
    private final List<SimulationObserver> observers = new CopyOnWriteArrayList<>();
    private final ConcurrentLinkedQueue<Runnable> orders = new ConcurrentLinkedQueue<>();
    private final Thread clock = new Thread(this::run, "small-simulation");
    private final AtomicInteger cyclesToStep = new AtomicInteger();
    private volatile boolean open = true;
    private volatile boolean paused;
    private volatile double speed = 1;
    private volatile PlayMode playMode = PlayMode.BEFORE_KICK_OFF;
    private volatile WorldSnapshot latest;
    private long cycle;
    private double gameTime;

    /** Waits until something has happened, or until it is clear that it never will. */
    static void awaitTrue(BooleanSupplier condition) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() > end) {
                throw new AssertionError("It did not happen within " + PATIENCE_SECONDS + " s.");
            }
            LockSupport.parkNanos(5_000_000);
        }
    }

    private record Member(
            Robot robot,
            RobotType type,
            TeamSide side,
            String team,
            int number,
            Vector3 home,
            double headingDegrees,
            Map<Joint, Double> posture) {}

    SmallSimulation() {
        latest = snapshot();
        clock.setDaemon(true);
    }

    SmallSimulation withRobot(
            RobotType type,
            TeamSide side,
            int number,
            double x,
            double y,
            double headingDegrees,
            Map<Joint, Double> posture) {
        Vector3 home = new Vector3(x, y, STANDING_HEIGHT);
        orders.add(() -> {
            Robot robot = world.addRobot(type);
            String team = side == TeamSide.LEFT ? "Blue Newbies" : "Orange Rockets";
            Member member = new Member(robot, type, side, team, number, home, headingDegrees, posture);
            members.add(member);
            putHome(member);
        });
        return this;
    }

    SmallSimulation withRobot() {
        return withRobot(RobotType.TYPE_0, TeamSide.LEFT, 1, -0.8, 0.3, 0, Posture.STANDING);
    }

    /** Runs some cycles at once, without the clock's thread. */
    WorldSnapshot afterCycles(int cycles) {
        for (Runnable order = orders.poll(); order != null; order = orders.poll()) {
            order.run();
        }
        for (int i = 0; i < cycles; i++) {
            advance();
        }
        return snapshot();
    }

    SmallSimulation start() {
        clock.start();
        return this;
    }

    /** The newest state that all observers have been told. */
    WorldSnapshot latest() {
        return latest;
    }

    private void run() {
        long next = System.nanoTime();
        while (open) {
            for (Runnable order = orders.poll(); order != null; order = orders.poll()) {
                order.run();
            }
            boolean stepping = cyclesToStep.getAndUpdate(n -> Math.max(0, n - 1)) > 0;
            if (!paused || stepping) {
                advance();
            }
            WorldSnapshot ended = snapshot();
            observers.forEach(observer -> observer.cycleEnded(ended));
            latest = ended;
            double wait = paused ? 5 * WorldSnapshot.CYCLE_SECONDS : WorldSnapshot.CYCLE_SECONDS / speed;
            next = Math.max(System.nanoTime(), next + (long) (1e9 * wait));
            while (cyclesToStep.get() == 0 && orders.isEmpty() && System.nanoTime() < next) {
                LockSupport.parkNanos(1_000_000);
            }
        }
    }

    private void advance() {
        members.forEach(SmallSimulation::holdPosture);
        world.step();
        cycle++;
        gameTime += WorldSnapshot.CYCLE_SECONDS;
    }

    private static void holdPosture(Member member) {
        for (Joint joint : Joint.values()) {
            double wanted = member.posture().getOrDefault(joint, 0.0);
            member.robot()
                    .setMotorSpeed(
                            joint, SPEED_PER_DEGREE * (wanted - member.robot().jointDegrees(joint)));
        }
    }

    private static void putHome(Member member) {
        member.robot().moveUpright(member.home(), member.headingDegrees() - 90);
    }

    private WorldSnapshot snapshot() {
        return new WorldSnapshot(
                cycle,
                gameTime,
                playMode,
                teamOf(TeamSide.LEFT),
                teamOf(TeamSide.RIGHT),
                0,
                0,
                1,
                world.ball().position(),
                floats(world.ball().rotation().toQuaternion()),
                robots(),
                paused,
                speed,
                paused ? 0 : speed);
    }

    private String teamOf(TeamSide side) {
        return members.stream()
                .filter(member -> member.side() == side)
                .map(Member::team)
                .findFirst()
                .orElse("");
    }

    private List<RobotSnapshot> robots() {
        List<RobotSnapshot> robots = new ArrayList<>();
        for (Member member : members) {
            NaoModel model = NaoModel.of(member.type());
            float[] poses = new float[7 * model.links().size()];
            for (int i = 0; i < model.links().size(); i++) {
                putPose(member.robot().linkPose(i), poses, 7 * i);
            }
            float[] degrees = new float[model.hinges().size()];
            for (int i = 0; i < degrees.length; i++) {
                degrees[i] = (float) member.robot().jointDegrees(i);
            }
            robots.add(new RobotSnapshot(
                    robots.size(),
                    member.team(),
                    Optional.of(member.side()),
                    member.number(),
                    member.type(),
                    poses,
                    degrees));
        }
        return robots;
    }

    private static void putPose(Pose pose, float[] poses, int at) {
        poses[at] = (float) pose.position().x();
        poses[at + 1] = (float) pose.position().y();
        poses[at + 2] = (float) pose.position().z();
        System.arraycopy(floats(pose.rotation().toQuaternion()), 0, poses, at + 3, 4);
    }

    private static float[] floats(double[] values) {
        float[] floats = new float[values.length];
        for (int i = 0; i < values.length; i++) {
            floats[i] = (float) values[i];
        }
        return floats;
    }

    /** Whether all steps that were asked for are done. */
    boolean standsStill() {
        return cyclesToStep.get() == 0;
    }

    @Override
    public SoccerField field() {
        return world.field();
    }

    @Override
    public void pause() {
        paused = true;
    }

    @Override
    public void resume() {
        paused = false;
    }

    @Override
    public void step(int cycles) {
        paused = true;
        cyclesToStep.addAndGet(cycles);
    }

    @Override
    public void setSpeed(double factor) {
        speed = factor;
    }

    @Override
    public void reset() {
        orders.add(() -> {
            gameTime = 0;
            playMode = PlayMode.BEFORE_KICK_OFF;
            world.ball().place(new Vector3(0, 0, world.ball().properties().radius()));
            members.forEach(SmallSimulation::putHome);
        });
    }

    @Override
    public void placeBall(Vector3 position, Vector3 velocity) {
        orders.add(() -> {
            world.ball().moveTo(position);
            world.ball().setVelocity(velocity);
        });
    }

    @Override
    public void placeRobot(TeamSide side, int number, Vector3 position, double headingDegrees) {
        orders.add(() -> members.stream()
                .filter(member -> member.side() == side && member.number() == number)
                .forEach(member -> member.robot().moveUpright(position, headingDegrees - 90)));
    }

    @Override
    public void kickOff(TeamSide side) {
        playMode = side == TeamSide.LEFT ? PlayMode.KICK_OFF_LEFT : PlayMode.KICK_OFF_RIGHT;
    }

    @Override
    public void dropBall() {
        playMode = PlayMode.PLAY_ON;
    }

    @Override
    public void setPlayMode(PlayMode playMode) {
        this.playMode = playMode;
    }

    @Override
    public void addObserver(SimulationObserver observer) {
        observers.add(observer);
    }

    @Override
    public void removeObserver(SimulationObserver observer) {
        observers.remove(observer);
    }

    @Override
    public void close() {
        open = false;
    }
}
