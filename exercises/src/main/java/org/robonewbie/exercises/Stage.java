package org.robonewbie.exercises;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.server.Console;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.server.SteppedSimulator;
import org.robonewbie.simulator.soccer.GameState;
import org.robonewbie.simulator.world.Ball;

/**
 * The beginners' pitch as the stage of an exercise: whole robots with noise and delay, and the truth about all of them. The world
 * waits for each program, so a trial with the same seed is the same trial.
 */
public final class Stage implements AutoCloseable {

    /** Length of a cycle. */
    public static final double CYCLE_SECONDS = 0.02;

    private static final int CYCLES_TO_APPEAR = 3;
    private static final int CYCLES_TO_SETTLE = 25;
    /** An agent needs 17 messages to begin: these in which it learns its number, and others to settle at its place. */
    private static final int CYCLES_TO_JOIN = 3;

    private static final int CYCLES_TO_WAKE = 14;

    private static final int CYCLES_TO_REST = 5;

    private final SteppedSimulator simulator;
    private final Audience audience;
    private final Random random;
    private final long seed;
    private final List<Player> players = new ArrayList<>();
    private String firstTeam = "";
    private long cycles;

    /**
     * Opens the pitch.
     *
     * @param seed start of all that is left to chance
     * @param recording file for a recording that the studio can show; empty for none
     * @param audience who looks on
     */
    Stage(long seed, Optional<Path> recording, Audience audience) throws IOException {
        this.seed = seed;
        this.audience = audience;
        SimulatorSettings settings = SimulatorSettings.beginner()
                .agentPort(0)
                .synchronous(true)
                .seed(seed)
                .recording(recording)
                .build();
        simulator = SteppedSimulator.start(settings, Console.silent());
        random = new Random(31 * seed + 17);
    }

    /**
     * Lets a robot in, whose joints are all at 0.
     *
     * @param program its program
     * @param team its team; the first team owns the left goal
     * @param number its number, 1 to 11
     * @param place where it begins
     * @return the robot
     */
    public Player add(Program program, String team, int number, Place place) {
        try {
            AgentLink link = simulator.connect();
            Player.create(link);
            for (int i = 0; i < CYCLES_TO_APPEAR; i++) {
                exchange();
            }
            boolean first = players.isEmpty() || team.equals(firstTeam);
            firstTeam = first ? team : firstTeam;
            program.introduce(team, number, first ? TeamSide.LEFT : TeamSide.RIGHT);
            Player player = new Player(link, simulator.world().robots().get(players.size()), program);
            for (Player other : players) {
                other.idle();
            }
            player.join(team, number);
            players.add(player);
            simulator.cycle();
            listen();
            simulator.match().setPlayMode(PlayMode.PLAY_ON);
            player.moveTo(place);
            for (int i = 0; i < CYCLES_TO_SETTLE; i++) {
                if (i < CYCLES_TO_JOIN || i >= CYCLES_TO_SETTLE - CYCLES_TO_WAKE) {
                    player.awake();
                }
                exchange();
            }
            return player;
        } catch (IOException broken) {
            throw new UncheckedIOException("The simulator of the exercise does not answer.", broken);
        }
    }

    /**
     * Lets one robot play motions before the trial begins; then its own program takes over.
     *
     * @param player a robot
     * @param student the program that takes over
     * @param names motions by name, in their order
     */
    public void prelude(Player player, Program student, String... names) {
        Puppet puppet = new Puppet();
        player.handOverTo(Program.of(puppet));
        for (String name : names) {
            puppet.play(name);
            goOn(player, puppet);
        }
        player.handOverTo(student);
        cycles = 0;
    }

    /**
     * Lets one robot go to a posture before the trial begins; then its own program takes over.
     *
     * @param player a robot
     * @param student the program that takes over
     * @param motion how to get there
     */
    public void prelude(Player player, Program student, Motion motion) {
        Puppet puppet = new Puppet();
        player.handOverTo(Program.of(puppet));
        puppet.play(motion);
        goOn(player, puppet);
        player.handOverTo(student);
        cycles = 0;
    }

    /** Lets all robots live through one cycle. */
    void cycle() {
        cycle(players);
    }

    private void cycle(List<Player> thinking) {
        try {
            for (Player player : players) {
                if (thinking.contains(player)) {
                    player.think();
                } else {
                    player.idle();
                }
            }
            simulator.cycle();
            listen();
            cycles++;
            audience.cycleEnded(this);
        } catch (IOException broken) {
            throw new UncheckedIOException("The simulator of the exercise does not answer.", broken);
        }
    }

    /**
     * Gives the robots.
     *
     * @return all robots in the order in which they came; the student's first
     */
    public List<Player> players() {
        return List.copyOf(players);
    }

    /**
     * Gives the student's robot.
     *
     * @return the first robot
     */
    public Player student() {
        return players.get(0);
    }

    /**
     * Gives the ball.
     *
     * @return the true ball
     */
    public Ball ball() {
        return simulator.world().ball();
    }

    /**
     * Puts the ball on the ground at rest.
     *
     * @param place where to; its height does not matter
     */
    public void placeBall(Vector3 place) {
        ball().place(new Vector3(place.x(), place.y(), ball().properties().radius()));
    }

    /**
     * Tells how the game stands.
     *
     * @return the referee's state
     */
    public GameState game() {
        return simulator.match().state();
    }

    /**
     * Gives chance, which is the same for the same seed.
     *
     * @return the random numbers of this trial
     */
    public Random random() {
        return random;
    }

    /**
     * Tells apart two kinds of trials.
     *
     * @return whether the seed of this trial is odd
     */
    public boolean isSeedOdd() {
        return seed % 2 != 0;
    }

    /**
     * Draws a number.
     *
     * @param least at least this
     * @param most less than this
     * @return a number of this trial
     */
    public double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }

    /**
     * Tells how long the trial lasts.
     *
     * @return simulated seconds since the student's program took over
     */
    public double seconds() {
        return cycles * CYCLE_SECONDS;
    }

    /**
     * Takes a picture of the world for those who look on.
     *
     * @param paused whether the world stands still
     * @param speed simulated seconds per second
     * @return the present state
     */
    public WorldSnapshot snapshot(boolean paused, double speed) {
        return simulator.snapshot(paused, speed);
    }

    @Override
    public void close() {
        players.forEach(Player::close);
        simulator.close();
    }

    /** Lets only the puppet move until its motion is over and its motors rest. */
    private void goOn(Player player, Puppet puppet) {
        do {
            cycle(List.of(player));
        } while (!puppet.isFinished());
        for (int i = 0; i < CYCLES_TO_REST; i++) {
            cycle(List.of(player));
        }
    }

    private void exchange() throws IOException {
        for (Player player : players) {
            player.idle();
        }
        simulator.cycle();
        listen();
        audience.cycleEnded(this);
    }

    private void listen() throws IOException {
        for (Player player : players) {
            player.listen();
        }
    }
}
