package org.robonewbie.agent;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.robonewbie.agent.cycle.CycleWatch;
import org.robonewbie.agent.cycle.LinkPort;
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
 * Drives an agent from outside, for tests, grading, learning and replay: perception in, commands out, without thread, clock or
 * simulator. Programs of robots do not need it.
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
     * Sets who the agent is, which a simulator would tell.
     *
     * @param who its team, its number and its type, among others
     * @param side the half of its team
     */
    public void introduce(Options who, TeamSide side) {
        agent.begin(who);
        agent.runtime().sensors().setType(who.robotType());
        agent.runtime().sensors().introduce(who.team(), who.number(), side);
    }

    /**
     * Watches the program while {@link #respond} runs it: reports a misspelt {@code think()}, cycles that do not end, and slow ones.
     *
     * @param listener called in the program's thread when many cycles have been slow, with what to do about it
     * @return ends watching
     */
    public Watchdog watch(Consumer<Slowness> listener) {
        agent.reportWhatIsMissing();
        Watchdog watchdog =
                Watchdog.start(CycleOwner.FRAMEWORK, agent.runtime().diagnostics(), Optional.empty(), listener);
        session = new Session(agent.runtime(), port, OptionalDouble.empty(), watchdog);
        return watchdog;
    }

    /**
     * Turns one cycle of the agent.
     *
     * @param message what the robot senses
     * @return what the robot does, with {@code Synchronise} at the end
     */
    public List<EffectorCommand> respond(PerceptorMessage message) {
        port.put(message);
        agent.run(session);
        return port.answer();
    }

    /**
     * Plays a whole game in the current thread, over a connection that may turn the simulator itself.
     *
     * @param link the robot's end of the connection
     * @param options who the robot is and where it starts
     * @throws IOException if the simulator closes the connection before the game
     * @throws StartUpException if the simulator refuses the robot
     */
    public void play(AgentLink link, Options options) throws IOException {
        join(link, options);
        resume();
    }

    /**
     * Enters a game over a connection, which is used up to the robot's first place. {@link #resume} plays.
     *
     * @param link the robot's end of the connection
     * @param options who the robot is and where it starts
     * @throws IOException if the simulator closes the connection before the game
     * @throws StartUpException if the simulator refuses the robot
     */
    public void join(AgentLink link, Options options) throws IOException {
        agent.begin(options);
        link.offerState(new AgentState(agent));
        LinkPort wire = new LinkPort(link, agent.runtime().sensors().buffer());
        new StartDialogue(wire, agent.runtime(), options).run(() -> {}, () -> {});
        session = new Session(agent.runtime(), wire, options.seconds(), CycleWatch.NONE);
    }

    /**
     * Goes on with the game that was {@link #join joined}: answers message after message, until the connection has no more. One
     * that does not wait for messages gives control back after each of them.
     */
    public void resume() {
        agent.run(session);
    }

    /**
     * Lets others see what the robot thinks.
     *
     * @param viewer receives it from now on
     */
    public void publishTo(TelemetrySink viewer) {
        agent.runtime().telemetry().publishTo(viewer);
    }

    /** {@return who the agent is and where it starts unless the user says otherwise} */
    public Options usualOptions() {
        return agent.defaults();
    }

    /** {@return the numbers that the agent has declared so far, in their order} */
    public List<TunableNumber> numbers() {
        return agent.numbers().list();
    }

    /** {@return whether a step of the agent has thrown an exception} */
    public boolean hasFailed() {
        return agent.hasFailed();
    }

    /**
     * Brings a robot into a game over a connection that is already open.
     *
     * @param link the robot's end of the connection
     * @param options who the robot is and where it starts
     * @return the robot on its first place
     * @throws StartUpException if the simulator does not let the robot in
     */
    public static Nao connect(AgentLink link, Options options) {
        return Nao.join(options, SimulatorConnection.of(link));
    }
}
