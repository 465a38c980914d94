package org.robonewbie.app.command;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.robonewbie.app.studio.LocalStudio;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ExampleCatalogue;
import org.robonewbie.programs.Program;
import org.robonewbie.programs.ProgramFinder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Unmatched;

/** {@code robonewbie run}: runs one agent, which is an example, one of the user's classes or a Java file. */
@Command(
        name = RunCommand.NAME,
        description = "Run an agent. If no simulator is running, this starts one and opens the studio in the browser.",
        customSynopsis = "robonewbie run [--class-path PATH] [--rehearse T] AGENT [OPTIONS OF THE AGENT]",
        footer = {
            "",
            "Examples:",
            "  robonewbie run Agent_BasicStructure",
            "  robonewbie run Agent_BasicStructure --headless --fast --seed 1 --seconds 12",
            "  robonewbie run MyAgent.java",
            "  robonewbie run --class-path target/classes my.team.Attacker --number 9",
            "  robonewbie run --rehearse 20 Agent_Team 11 --team Blue --port 3100"
        })
final class RunCommand implements Callable<Integer> {

    static final String NAME = "run";

    private static final List<String> SERVER = List.of("--host", "--port");
    private static final List<String> SIMULATOR =
            List.of("--host", "--port", "--seed", "--seconds", "--report", "--record", "--wait-for", "--scene");
    private static final List<String> SIMULATOR_FLAGS = List.of("--fast", "--headless", "--no-browser", "--truth");

    @Mixin
    final HelpOption help = new HelpOption();

    @Mixin
    private final ClassPathOption classPath = new ClassPathOption();

    @Option(
            names = "--rehearse",
            paramLabel = "T",
            description = "Warm up before a real-time match: run the agent for T simulated seconds in a separate"
                    + " simulator, so that Java compiles it in advance.")
    private double rehearsalSeconds;

    @Parameters(
            arity = "0..*",
            paramLabel = "AGENT",
            description = "Name of an example or of your class, or a .java file; the agent's options follow.")
    private List<String> agentAndOptions = List.of();

    @Unmatched
    private final List<String> optionsBeforeTheAgent = new ArrayList<>();

    @Override
    public Integer call() throws IOException {
        if (!optionsBeforeTheAgent.isEmpty()) {
            throw new CalledWronglyException("The agent comes before its options: robonewbie run "
                    + ExampleCatalogue.FIRST_EXAMPLE + " " + optionsBeforeTheAgent.get(0));
        }
        ProgramFinder finder = new ProgramFinder(classPath.folders());
        if (!(rehearsalSeconds >= 0)) {
            throw new CalledWronglyException(
                    "--rehearse " + rehearsalSeconds + " is not valid. Use a number of seconds, at least 0.");
        }
        if (agentAndOptions.isEmpty()) {
            throw new CalledWronglyException("Which agent do you want to run? For example: robonewbie run "
                    + ExampleCatalogue.FIRST_EXAMPLE + System.lineSeparator() + finder.listOfExamples());
        }
        List<String> options = agentAndOptions.subList(1, agentAndOptions.size());
        Program program = finder.find(agentAndOptions.get(0));
        if (rehearsalSeconds > 0) {
            rehearse(program, options);
        }
        return run(agentAndOptions.get(0), program, options);
    }

    /** Runs a program; its studio opens the file, class or example with the given name. */
    static int run(String name, Program program, List<String> options) {
        List<String> ofRobot = without(SIMULATOR, options);
        ofRobot.removeAll(SIMULATOR_FLAGS);
        LocalStudio.setProgram(name, ofRobot);
        return program.run(options);
    }

    /** Runs the program without output before the actual run, which repeats any errors and shows them. */
    private void rehearse(Program program, List<String> options) throws IOException {
        List<String> all = without(SERVER, options);
        all.addAll(List.of("--seed", "1", "--fast", "--headless", "--seconds", Double.toString(rehearsalSeconds)));
        System.out.println("Rehearsing for " + rehearsalSeconds + " simulated seconds");
        SilentPrograms.entirely(() -> program.run(all));
    }

    /**
     * Removes the options with the given names and their values, written as {@code --port 3100} or {@code --port=3100}.
     */
    private static List<String> without(List<String> names, List<String> options) {
        List<String> others = new ArrayList<>();
        for (int i = 0; i < options.size(); i++) {
            String option = options.get(i);
            if (names.contains(option)) {
                i++;
            } else if (!names.contains(option.replaceFirst("=.*", ""))) {
                others.add(option);
            }
        }
        return others;
    }
}
