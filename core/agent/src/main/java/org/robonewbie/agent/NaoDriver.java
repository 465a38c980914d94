package org.robonewbie.agent;

import java.io.IOException;
import org.robonewbie.agent.cycle.CycleWatch;
import org.robonewbie.agent.cycle.LinkPort;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.agent.cycle.Session;
import org.robonewbie.agent.running.SimulatorConnection;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/**
 * Runs a {@link Nao} for a caller that advances the world between two calls from the robot's program, such as a web
 * page that steps through the program. It works without a thread, clock or simulator. Robot programs do not need this
 * class.
 */
public final class NaoDriver {

    private final Session session;
    private final Nao nao;

    private NaoDriver(RobotRuntime runtime, Session session, AgentLink link) {
        this.session = session;
        nao = new Nao(runtime, session, SimulatorConnection.of(link), () -> {});
    }

    /**
     * Joins a game over an open connection.
     *
     * @param link the robot's end of the connection
     * @param options options that include team, number, type and starting pose
     * @param viewer receives the robot's telemetry
     * @return a driver with the robot at its starting pose
     * @throws IOException if the simulator closes the connection before the game begins
     * @throws StartUpException if the simulator refuses the robot
     */
    public static NaoDriver enter(AgentLink link, Options options, TelemetrySink viewer) throws IOException {
        RobotRuntime runtime = new RobotRuntime("the robot");
        runtime.telemetry().publishTo(viewer);
        LinkPort port = new LinkPort(link, runtime.sensors().buffer());
        new StartDialogue(port, runtime, options).run(() -> {}, () -> {});
        return new NaoDriver(runtime, new Session(runtime, port, options.seconds(), CycleWatch.NONE), link);
    }

    /** {@return the robot} */
    public Nao nao() {
        return nao;
    }

    /** Answers the last message, unless it has already been answered, so that the world can advance. */
    public void complete() {
        session.complete();
    }
}
