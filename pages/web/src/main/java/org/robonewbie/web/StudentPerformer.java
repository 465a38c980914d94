package org.robonewbie.web;

import java.io.PrintStream;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.SensorReadings;
import org.robonewbie.pagejvm.Machine;
import org.robonewbie.pagejvm.Program;

/** A robot of a trial that a student's agent moves, with static fields of its own. */
final class StudentPerformer implements Controller {

    private final Machine machine;
    private final AgentDriver agent;

    /**
     * Makes the agent.
     *
     * @param program its classes, which no other robot uses
     * @param output what it prints
     * @param viewer receives what the robot thinks
     * @throws IllegalArgumentException if the program has no agent; the message is a sentence for the user
     */
    StudentPerformer(Program program, PrintStream output, TelemetrySink viewer) {
        machine = new Machine(program, output, StudentPerformer::special);
        PageMemory.lookAt(machine::trace);
        agent = new AgentDriver((Agent) machine.create(agentOf(program)));
        agent.publishTo(viewer);
    }

    /**
     * Finds the agent of a program.
     *
     * @param program the program
     * @return the name of its class
     * @throws IllegalArgumentException if the program has none; the message is a sentence for the user
     */
    static String agentOf(Program program) {
        return program.agents().stream()
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "An exercise wants a class that extends Agent and has a constructor without parameters; the program"
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
        PageMemory.lookAt(machine::trace);
        return agent.respond(readings.message());
    }
}
