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
 * Holds a {@link Nao} for somebody who turns the world between two calls of its program, such as a page that steps through it: without
 * thread, clock or simulator. Programs of robots do not need it.
 */
public final class NaoDriver {

    private final Session session;
    private final Nao nao;

    private NaoDriver(RobotRuntime runtime, Session session, AgentLink link) {
        this.session = session;
        nao = new Nao(runtime, session, SimulatorConnection.of(link), () -> {});
    }

    /**
     * Brings a robot into a game over a connection that is already open.
     *
     * @param link the robot's end of the connection
     * @param options who the robot is and where it starts
     * @param viewer receives what the robot thinks
     * @return its driver, with the robot on its first place
     * @throws IOException if the simulator closes the connection before the game
     * @throws StartUpException if the simulator does not let the robot in
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

    /** Answers the last message if that has not happened yet, so that the world may go on. */
    public void complete() {
        session.complete();
    }
}
