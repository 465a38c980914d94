package org.robonewbie.web;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Nao;
import org.robonewbie.agent.NaoDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.pagejvm.Machine;
import org.robonewbie.pagejvm.Program;
import org.robonewbie.pagejvm.SpecialCalls;
import org.robonewbie.pagejvm.Waiting;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/**
 * A student's program in a world that is advanced elsewhere. Calls that would wait for a simulator suspend the program until the next
 * message. These are {@code run} of an agent, and {@code sense} and {@code perform} of a {@code Nao}.
 */
final class StudentProgram {

    /** A practically unlimited time, because the user, not the program, ends the game. */
    static final double FOREVER_SECONDS = 1e6;

    private final Machine machine;
    private final Function<Runnable, AgentLink> entrance;
    private final Runnable nextCycle;
    private final TelemetrySink viewer;
    private final List<AgentDriver> drivers = new ArrayList<>();
    private final List<PatientLink> links = new ArrayList<>();
    private @Nullable NaoDriver held;
    private @Nullable PatientLink link;

    /**
     * Loads a program.
     *
     * @param program the program's classes
     * @param output receives the program's output
     * @param entrance opens a connection for a robot; runs the given action repeatedly while the robot is joining
     * @param nextCycle advances the world while a robot is joining or the program is waiting inside compiled code
     * @param viewer receives the robots' telemetry
     */
    StudentProgram(
            Program program,
            PrintStream output,
            Function<Runnable, AgentLink> entrance,
            Runnable nextCycle,
            TelemetrySink viewer) {
        this.entrance = entrance;
        this.nextCycle = nextCycle;
        this.viewer = viewer;
        machine = new Machine(program, output, this::special);
        PageMemory.setProgram(machine::trace);
        List<String> mains = program.mainClasses();
        if (!mains.isEmpty()) {
            machine.begin(mains.get(0));
        } else if (!program.agents().isEmpty()) {
            join((Agent) machine.create(program.agents().get(0)));
        } else {
            throw new IllegalArgumentException("The program has neither an agent nor a main method: start with"
                    + " \"public class MyAgent extends Agent\".");
        }
    }

    /**
     * Runs the program until it waits for the next message.
     *
     * @return whether the program has ended
     */
    boolean resume() {
        if (machine.resume()) {
            drivers.forEach(AgentDriver::resume);
            return drivers.isEmpty();
        }
        return false;
    }

    /** Disconnects the program's robots, regardless of the program's state. */
    void leave() {
        links.forEach(PatientLink::close);
    }

    private PatientLink enter() {
        PatientLink own = new PatientLink(entrance.apply(this::turn));
        links.add(own);
        return own;
    }

    /** Lets the robots that have already joined respond while another one is joining. */
    private void turn() {
        nextCycle.run();
        drivers.forEach(AgentDriver::resume);
    }

    /** {@return whether a step of an agent has thrown an exception} */
    boolean hasFailed() {
        return drivers.stream().anyMatch(AgentDriver::hasFailed);
    }

    private void join(Agent agent, String... arguments) {
        AgentDriver driver = new AgentDriver(agent);
        driver.publishTo(viewer);
        PatientLink own = enter();
        try {
            driver.join(own, driver.defaultOptions().overriddenBy(arguments).withSeconds(FOREVER_SECONDS));
        } catch (IOException impossible) {
            throw new UncheckedIOException("The simulator on this page has closed the connection.", impossible);
        }
        own.stopWaiting();
        drivers.add(driver);
    }

    private @Nullable Object special(String owner, String name, @Nullable Object target, @Nullable Object[] arguments) {
        if (target instanceof Nao nao) {
            return ofNao(name, nao, arguments);
        }
        if (owner.equals("org/robonewbie/agent/Nao") && name.equals("connect")) {
            return connect(Objects.requireNonNull(arguments[0]));
        }
        if (target instanceof Agent agent && name.equals("run")) {
            return play((String[]) Objects.requireNonNull(arguments[0]), agent);
        }
        if (name.equals("runTogether")) {
            return play(
                    (String[]) Objects.requireNonNull(arguments[0]), (Agent[]) Objects.requireNonNull(arguments[1]));
        }
        return PageCalls.call(owner, name, arguments);
    }

    private Object play(String[] arguments, Agent... agents) {
        for (Agent agent : agents) {
            join(agent, arguments);
        }
        List<AgentDriver> own = List.copyOf(drivers);
        drivers.clear();
        return new Later(
                () -> {
                    own.forEach(AgentDriver::resume);
                    return false;
                },
                () -> null,
                nextCycle);
    }

    private Nao connect(Object wanted) {
        Options options =
                (wanted instanceof Options given ? given : Options.of((String[]) wanted)).withSeconds(FOREVER_SECONDS);
        PatientLink own = enter();
        try {
            NaoDriver driver = NaoDriver.enter(own, options, viewer);
            own.stopWaiting();
            link = own;
            held = driver;
            return driver.nao();
        } catch (IOException impossible) {
            throw new UncheckedIOException("The simulator on this page has closed the connection.", impossible);
        }
    }

    private @Nullable Object ofNao(String name, Nao nao, @Nullable Object[] arguments) {
        NaoDriver driver = Objects.requireNonNull(held);
        PatientLink own = Objects.requireNonNull(link);
        if (name.equals("sense")) {
            driver.complete();
            return new Later(
                    own::isMessageWaiting,
                    () -> {
                        machine.newCycle();
                        return nao.sense() ? 1 : 0;
                    },
                    nextCycle);
        }
        if (name.equals("perform")) {
            driver.complete();
            return new Performance(nao, (String) Objects.requireNonNull(arguments[0]), driver, own);
        }
        return SpecialCalls.UNKNOWN;
    }

    /** A suspended call; its result becomes available when the next message arrives. */
    private record Later(BooleanSupplier ready, Supplier<@Nullable Object> outcome, Runnable nextCycle)
            implements Waiting {

        @Override
        public boolean isReady() {
            return ready.getAsBoolean();
        }

        @Override
        public void hurry() {
            nextCycle.run();
        }

        @Override
        public @Nullable Object result() {
            return outcome.get();
        }
    }

    /** A suspended call to {@code perform}; it returns when the motion has ended. */
    private final class Performance implements Waiting {

        private final Nao nao;
        private final NaoDriver driver;
        private final PatientLink own;
        private boolean performing;

        Performance(Nao nao, String motion, NaoDriver driver, PatientLink own) {
            this.nao = nao;
            this.driver = driver;
            this.own = own;
            performing = nao.motions().start(motion);
        }

        @Override
        public boolean isReady() {
            if (isRunning() && own.isMessageWaiting()) {
                machine.newCycle();
                performing = nao.sense();
                driver.complete();
            }
            return !isRunning();
        }

        private boolean isRunning() {
            return performing && !nao.motions().isFinished();
        }

        @Override
        public void hurry() {
            nextCycle.run();
        }

        @Override
        public Object result() {
            return performing ? 1 : 0;
        }
    }
}
