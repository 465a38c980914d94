package org.robonewbie.app.command;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.TunableNumbers;
import org.robonewbie.learning.optimise.AgentParametrization;
import org.robonewbie.learning.optimise.AgentScene;
import org.robonewbie.learning.optimise.Objective;
import org.robonewbie.nao.Vector3;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ProgramFinder;
import org.robonewbie.programs.StudentsAgents;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Command-line options for an agent whose parameters are optimised, and for the scene of its trials. */
public final class OptimisedAgent {

    @Option(
            names = "--agent",
            paramLabel = "CLASS",
            description = "Optimise the numbers that an agent declares with number(...). The agent can be given as the"
                    + " name of an example, the name of your class, or a .java file.")
    private Optional<String> program = Optional.empty();

    @Option(
            names = "--pose",
            paramLabel = "X,Y,DEGREES",
            split = ",",
            description = "With --agent: initial pose (default: -1,0,0).")
    private List<Double> pose = List.of(-1.0, 0.0, 0.0);

    @Option(
            names = "--ball",
            paramLabel = "X,Y",
            split = ",",
            description = "With --agent: position of the ball (default: 0,0).")
    private List<Double> ball = List.of(0.0, 0.0);

    @Option(
            names = "--spread",
            paramLabel = "METRES",
            defaultValue = "0.2",
            description = "With --agent: maximum random offset of the robot and the ball in each trial (default: 0.2).")
    private double spread;

    @Option(
            names = "--seconds",
            paramLabel = "T",
            defaultValue = "20",
            description = "With --agent: length of a trial in simulated seconds (default: 20).")
    private double seconds;

    @Mixin
    private final ClassPathOption classPath = new ClassPathOption();

    /** {@return whether an agent was specified} */
    public boolean isGiven() {
        return program.isPresent();
    }

    /** {@return whether the agent is a {@code .java} file} */
    public boolean isSourceFile() {
        return program.filter(name -> name.endsWith(".java")).isPresent();
    }

    /** {@return the simple name of the agent's class} */
    public String simpleName() {
        String name = String.valueOf(Path.of(program.orElse("")).getFileName()).replaceFirst("\\.java$", "");
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /** {@return the file from which the agent reads its parameters} */
    public Path file() {
        return Path.of(TunableNumbers.fileName(simpleName()));
    }

    /**
     * Looks up an objective: a built-in measure or a class on the class path.
     *
     * @param label the name of the measure
     * @return the objective
     */
    public Objective objective(String label) {
        return Objective.named(label, ProgramFinder.loaderOf(classPath.folders()));
    }

    /**
     * Creates the parametrization of the agent.
     *
     * @param objective the objective
     * @return the parametrization
     */
    public AgentParametrization subject(Objective objective) {
        if (pose.size() != 3 || ball.size() != 2) {
            throw new CalledWronglyException(
                    "--pose needs three numbers, such as -1,0,0, and --ball two, such as 0,0. Given: " + pose + " and "
                            + ball + ".");
        }
        String name = program.orElseThrow();
        List<Path> folders = classPath.folders();
        StudentsAgents agents = new StudentsAgents(new ProgramFinder(folders).findClass(name));
        AgentScene scene = new AgentScene(
                new Vector3(pose.get(0), pose.get(1), 0),
                pose.get(2),
                new Vector3(ball.get(0), ball.get(1), 0),
                spread,
                seconds);
        return new AgentParametrization(name, () -> created(agents), objective, scene);
    }

    private static Agent created(StudentsAgents agents) {
        try {
            return agents.get();
        } catch (IllegalStateException broken) {
            throw new CalledWronglyException("The agent cannot be created: " + broken.getMessage() + ".");
        }
    }
}
