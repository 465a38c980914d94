package org.robonewbie.web;

import java.io.PrintStream;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.pagejvm.Machine;
import org.robonewbie.pagejvm.Program;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.SensorReadings;

/** Controller that runs a student's agent on a robot in a trial. Each robot has its own copy of the program's static fields. */
final class StudentController implements Controller {

    private final Machine machine;
    private final AgentDriver agent;

    /**
     * Creates the agent.
     *
     * @param program the program's classes, not shared with another robot
     * @param output receives the program's output
     * @param viewer receives the robot's telemetry
     * @throws IllegalArgumentException if the program has no agent; the message is shown to the user
     */
    StudentController(Program program, PrintStream output, TelemetrySink viewer) {
        machine = new Machine(program, output, StudentController::special);
        PageMemory.setProgram(machine::trace);
        agent = new AgentDriver((Agent) machine.create(agentOf(program)));
        agent.publishTo(viewer);
    }

    /**
     * Finds the agent of a program.
     *
     * @param program the program
     * @return the class name of the agent
     * @throws IllegalArgumentException if the program has none; the message is shown to the user
     */
    static String agentOf(Program program) {
        return program.agents().stream()
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "An exercise needs a class that extends Agent and has a constructor without parameters; this program"
                                + " has none."));
    }

    private static @Nullable Object special(
            String owner, String name, @Nullable Object target, @Nullable Object[] arguments) {
        return PageCalls.call(owner, name, arguments);
    }

    @Override
    public void introduce(String team, int number, TeamSide side) {
        agent.introduce(Options.none().withTeam(team).withNumber(number), side);
    }

    @Override
    public List<EffectorCommand> respond(SensorReadings readings) {
        PageMemory.setProgram(machine::trace);
        return agent.respond(readings.message());
    }
}
