package org.robonewbie.agent;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.robonewbie.agent.cycle.CycleWatch;
import org.robonewbie.agent.cycle.LinkPort;
import org.robonewbie.agent.cycle.MessagePort;
import org.robonewbie.agent.cycle.Session;
import org.robonewbie.agent.cycle.SingleMessagePort;
import org.robonewbie.agent.running.CycleOwner;
import org.robonewbie.agent.running.SimulatorConnection;
import org.robonewbie.agent.running.Slowness;
import org.robonewbie.agent.running.Watchdog;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/**
 * Runs an agent without a thread, clock or simulator: perception in, commands out. Intended for tests, grading,
 * learning and replays; robot programs do not need this class.
 *
 * <pre>{@code
 * AgentDriver driver = new AgentDriver(new MyAgent());
 * driver.introduce(Options.none().withTeam("Blue").withNumber(1), TeamSide.LEFT);
 * List<EffectorCommand> answer = driver.respond(message);
 * }</pre>
 */
public final class AgentDriver {

    private final Agent agent;
    private final SingleMessagePort port = new SingleMessagePort();
    private Session session;

    /**
     * Creates a driver.
     *
     * @param agent the agent; it must not run anywhere else
     */
    public AgentDriver(Agent agent) {
        this.agent = agent;
        this.session = new Session(agent.runtime(), port, OptionalDouble.empty(), CycleWatch.NONE);
    }

    /**
     * Sets the identity that a simulator would assign.
     *
     * @param identity options that include team, number and robot type
     * @param side the half that the team defends
     */
    public void introduce(Options identity, TeamSide side) {
        agent.begin(identity);
        agent.runtime().sensors().setType(identity.robotType());
        agent.runtime().sensors().introduce(identity.team(), identity.number(), side);
    }

    /**
     * Starts a watchdog for {@link #respond}: reports a misspelt {@code think()}, infinite loops and slow cycles.
     *
     * @param listener called in the program's thread, with the cause of the slowness, once many cycles have been slow
     * @return the watchdog; close it to stop watching
     */
    public Watchdog watch(Consumer<Slowness> listener) {
        agent.reportWhatIsMissing();
        Watchdog watchdog =
                Watchdog.start(CycleOwner.FRAMEWORK, agent.runtime().diagnostics(), Optional.empty(), listener);
        session = new Session(agent.runtime(), port, OptionalDouble.empty(), watchdog);
        return watchdog;
    }

    /**
     * Runs one cycle of the agent.
     *
     * @param message the perceptors' readings
     * @return the robot's commands, with {@code Synchronise} at the end
     */
    public List<EffectorCommand> respond(PerceptorMessage message) {
        port.put(message);
        agent.run(session);
        return port.answer();
    }

    /**
     * Plays a whole game in the current thread.
     *
     * @param link the robot's end of the connection
     * @param options options that include team, number, type and starting pose
     * @throws IOException if the simulator closes the connection before the game begins
     * @throws StartUpException if the simulator refuses the robot
     */
    public void play(AgentLink link, Options options) throws IOException {
        join(link, options);
        resume();
    }

    /**
     * Joins a game and beams to the starting pose. Call {@link #resume} to play.
     *
     * @param link the robot's end of the connection
     * @param options options that include team, number, type and starting pose
     * @throws IOException if the simulator closes the connection before the game begins
     * @throws StartUpException if the simulator refuses the robot
     */
    public void join(AgentLink link, Options options) throws IOException {
        join(link, new LinkPort(link, agent.runtime().sensors().buffer()), options);
    }

    /**
     * Joins a game on the server of the robot that the options name, such as a T1.
     *
     * @param link the robot's end of the connection
     * @param options options that include robot, team, number and starting pose
     * @throws IOException if the server closes the connection before the game begins
     * @throws StartUpException if the server refuses the robot
     */
    public void joinLeague(AgentLink link, Options options) throws IOException {
        join(link, AgentRunner.port(agent.runtime(), link, options), options);
    }

    private void join(AgentLink link, MessagePort wire, Options options) throws IOException {
        agent.begin(options);
        link.offerState(new AgentState(agent));
        new StartDialogue(wire, agent.runtime(), options).run(() -> {}, () -> {});
        session = new Session(agent.runtime(), wire, options.seconds(), CycleWatch.NONE);
    }

    /**
     * Plays the {@link #join joined} game until the connection delivers no more messages. With a non-blocking
     * connection, this method returns after each message.
     */
    public void resume() {
        agent.run(session);
    }

    /**
     * Sets the receiver of the robot's telemetry.
     *
     * @param viewer the receiver
     */
    public void publishTo(TelemetrySink viewer) {
        agent.runtime().telemetry().publishTo(viewer);
    }

    /** {@return the agent's default options} */
    public Options defaultOptions() {
        return agent.defaults();
    }

    /** {@return the tunable numbers that the agent has declared so far, in order of declaration} */
    public List<TunableNumber> numbers() {
        return agent.numbers().list();
    }

    /** {@return whether a step of the agent has thrown an exception} */
    public boolean hasFailed() {
        return agent.hasFailed();
    }

    /**
     * Joins a game over an open connection.
     *
     * @param link the robot's end of the connection
     * @param options options that include team, number, type and starting pose
     * @return the robot at its starting pose
     * @throws StartUpException if the simulator refuses the robot
     */
    public static Nao connect(AgentLink link, Options options) {
        return Nao.join(options, SimulatorConnection.of(link));
    }
}
