package org.robonewbie.studio;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld;
import org.robonewbie.simulator.world.BallProperties;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** A simulation of the real world with robots that hold a posture instead of being controlled by agents. */
final class SmallSimulation implements SimulationControl, AutoCloseable {

    private static final long PATIENCE_SECONDS = 120;
    private static final double STANDING_HEIGHT = 0.366;
    private static final double SPEED_PER_DEGREE = 0.12;

    private final SoccerWorld world;
    private final List<Member> members = new CopyOnWriteArrayList<>();
    private final List<SimulationObserver> observers = new CopyOnWriteArrayList<>();
    private final LinkedBlockingQueue<Runnable> orders = new LinkedBlockingQueue<>();
    private final Semaphore turns = new Semaphore(0);
    private final Thread clock = new Thread(this::run, "small-simulation");
    private final AtomicInteger cyclesToStep = new AtomicInteger();
    private volatile boolean open = true;
    private volatile boolean paused;
    private volatile double speed = 1;
    private volatile Optional<TrialLabel> trial = Optional.empty();
    private volatile PlayMode playMode = PlayMode.BEFORE_KICK_OFF;
    private volatile WorldSnapshot latest;
    private long cycle;
    private double gameTime;

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
        this(Landscape.SOCCER);
    }

    SmallSimulation(Landscape landscape) {
        world = new SoccerWorld(SoccerField.BEGINNER, BallProperties.STANDARD, new SparsePhysicsWorld(), landscape);
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

    /** Runs some cycles synchronously, without the clock's thread. */
    WorldSnapshot afterCycles(int cycles) {
        obey();
        for (int i = 0; i < cycles; i++) {
            advance();
        }
        return snapshot();
    }

    SmallSimulation start() {
        clock.start();
        return this;
    }

    /** The latest state that all observers have received. */
    WorldSnapshot latest() {
        return latest;
    }

    /** Waits until a condition holds, which is evaluated after each turn of the simulation. */
    void awaitTrue(BooleanSupplier condition) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        turns.drainPermits();
        while (!condition.getAsBoolean()) {
            if (!hasTurned() || System.nanoTime() > end) {
                throw new AssertionError("It did not happen within " + PATIENCE_SECONDS + " s.");
            }
            turns.drainPermits();
        }
    }

    private boolean hasTurned() {
        try {
            return turns.tryAcquire(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException isOver) {
            throw new AssertionError(isOver);
        }
    }

    private void run() {
        long next = System.nanoTime();
        while (open) {
            obey();
            boolean stepping = cyclesToStep.getAndUpdate(n -> Math.max(0, n - 1)) > 0;
            if (!paused || stepping) {
                advance();
            }
            WorldSnapshot ended = snapshot();
            observers.forEach(observer -> observer.cycleEnded(ended));
            latest = ended;
            turns.release();
            double wait = paused ? 5 * Cycle.SECONDS : Cycle.SECONDS / speed;
            next = Math.max(System.nanoTime(), next + (long) (1e9 * wait));
            awaitOrderUntil(next);
        }
    }

    private void obey() {
        for (Runnable order = orders.poll(); order != null; order = orders.poll()) {
            order.run();
        }
    }

    private void awaitOrderUntil(long nanoseconds) {
        try {
            Runnable order =
                    cyclesToStep.get() > 0 ? null : orders.poll(nanoseconds - System.nanoTime(), TimeUnit.NANOSECONDS);
            if (order != null) {
                order.run();
            }
        } catch (InterruptedException isOver) {
            open = false;
        }
    }

    private void advance() {
        members.forEach(SmallSimulation::holdPosture);
        world.step();
        cycle++;
        gameTime += Cycle.SECONDS;
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
                world.ball().rotation().toQuaternion(),
                robots(),
                world.things().now(),
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
            robots.add(new RobotSnapshot(
                    robots.size(),
                    member.team(),
                    Optional.of(member.side()),
                    member.number(),
                    member.robot().body()));
        }
        return robots;
    }

    /** Returns whether all requested steps are done. */
    boolean standsStill() {
        return cyclesToStep.get() == 0;
    }

    /** Sets the label of the trial that runs from now on. */
    void judging(TrialLabel label) {
        trial = Optional.of(label);
    }

    @Override
    public Optional<TrialLabel> trial() {
        return trial;
    }

    @Override
    public SoccerField field() {
        return world.field();
    }

    @Override
    public void order(Order order) {
        if (order instanceof Order.Pause) {
            paused = true;
        } else if (order instanceof Order.Resume) {
            paused = false;
        } else if (order instanceof Order.Step step) {
            paused = true;
            cyclesToStep.addAndGet(step.cycles());
            orders.add(() -> {}); // wakes the clock
        } else if (order instanceof Order.SetSpeed set) {
            speed = set.factor();
        } else if (order instanceof Order.KickOff kickOff) {
            playMode = kickOff.side().equals(Optional.of(TeamSide.LEFT))
                    ? PlayMode.KICK_OFF_LEFT
                    : PlayMode.KICK_OFF_RIGHT;
        } else if (order instanceof Order.DropBall) {
            playMode = PlayMode.PLAY_ON;
        } else if (order instanceof Order.ChangePlayMode change) {
            playMode = change.playMode();
        } else {
            orders.add(() -> move(order));
        }
    }

    private void move(Order order) {
        if (order instanceof Order.Reset) {
            gameTime = 0;
            playMode = PlayMode.BEFORE_KICK_OFF;
            world.ball().place(new Vector3(0, 0, world.ball().properties().radius()));
            members.forEach(SmallSimulation::putHome);
        } else if (order instanceof Order.MoveBall move) {
            move.position().ifPresent(world.ball()::moveTo);
            move.velocity().ifPresent(world.ball()::setVelocity);
        } else if (order instanceof Order.PlaceRobot place) {
            members.stream()
                    .filter(member -> new PlayerNumber(member.side(), member.number()).equals(place.player()))
                    .forEach(member -> member.robot().moveUpright(place.position(), place.headingDegrees() - 90));
        }
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
