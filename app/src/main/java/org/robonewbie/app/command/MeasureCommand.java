package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.robonewbie.learning.measure.MotionMeasurement;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;

/** Tries all shipped motions or the example agents many times, or a server under load, and prints how well that works. */
@Command
final class MeasureCommand implements Callable<Integer> {

    private static final String MOTIONS = "motions";
    private static final String AGENTS = "agents";
    private static final String TEAM = "team";
    private static final String SERVER = "server";
    private static final Map<String, String> DESCRIPTIONS = Map.of(
            MOTIONS, "Try all shipped motions many times in the simulator.",
            AGENTS, "Let each example agent play many times.",
            TEAM, "Let the example team play halves against as many others.",
            SERVER, "Let many robots play whole matches over TCP; does the server keep step with the clock?");

    private static final Map<String, String[]> FOOTERS = Map.of(
            MOTIONS,
            examples(
                    "robonewbie bench motions                20 trials of each motion",
                    "robonewbie bench motions --seeds 3      a quick look",
                    "robonewbie bench motions --first-seed 1000 --json result.json"),
            AGENTS,
            examples("robonewbie bench agents                 20 games of each example agent"),
            TEAM,
            examples(
                    "robonewbie bench team --players 3       20 halves, 3 against 3",
                    "robonewbie bench team --players 1       one player alone, for 5 minutes of open play"),
            SERVER,
            examples(
                    "robonewbie bench server                 11 against 11 for 10 minutes on the clock",
                    "robonewbie bench server --fast --matches 3"));

    /** What can be measured. */
    static final List<String> SUBJECTS = List.of(MOTIONS, AGENTS, TEAM, SERVER);

    @Mixin
    final HelpOption help = new HelpOption();

    private final String subject;

    @Option(
            names = "--seeds",
            paramLabel = "N",
            defaultValue = "20",
            description =
                    "motions, agents: trials of each one, each disturbed in another way; team: halves (default: 20).")
    private int seeds;

    @Option(
            names = "--first-seed",
            paramLabel = "N",
            defaultValue = "1",
            description =
                    "motions, agents, team: seed of the first trial; another one disturbs in other ways (default: 1).")
    private long firstSeed;

    @Option(
            names = "--only",
            paramLabel = "PART",
            defaultValue = "",
            description = "motions, agents: only those whose name has this in it, such as kick.")
    private String part = "";

    @Option(
            names = "--type",
            paramLabel = "0..4",
            defaultValue = "0",
            description = "motions: how the robot is built; types 1 to 4 walk on a whole simulator only (default: 0).")
    private int type;

    @Option(names = "--json", paramLabel = "FILE", description = "motions, agents: write the results as JSON too.")
    private Optional<Path> json = Optional.empty();

    @Option(
            names = "--players",
            paramLabel = "N",
            defaultValue = "3",
            description = "team: players of each team, 1 to 11; 1 plays alone (default: 3).")
    private int players;

    @Option(
            names = "--against",
            paramLabel = "AGENT",
            defaultValue = TeamMeasurement.USUAL_OPPONENT,
            description = "team: who the others are, Agent_BetterSoccer or Agent_Team (default: Agent_BetterSoccer).")
    private String opponent = TeamMeasurement.USUAL_OPPONENT;

    @Mixin
    final ServerLoadOptions load = new ServerLoadOptions();

    @Mixin
    final WithoutStudioOption withoutStudio = new WithoutStudioOption();

    private static String[] examples(String... lines) {
        return Stream.concat(Stream.of("", "Examples:"), Stream.of(lines).map(line -> "  " + line))
                .toArray(String[]::new);
    }

    private MeasureCommand(String subject) {
        this.subject = subject;
    }

    /** Makes a command that measures one subject. */
    static CommandLine of(String subject) {
        CommandSpec spec =
                CommandSpec.forAnnotatedObject(new MeasureCommand(subject)).name(subject);
        spec.usageMessage().description(DESCRIPTIONS.get(subject)).footer(FOOTERS.get(subject));
        return new CommandLine(spec);
    }

    @Override
    public Integer call() throws IOException {
        if (subject.equals(SERVER)) {
            return load.measure();
        }
        if (players < 1 || players > 11) {
            throw new CalledWronglyException("--players " + players + ": a team has 1 to 11 players.");
        }
        if (seeds < 1) {
            throw new CalledWronglyException("--seeds " + seeds + ": give a number of trials of at least 1.");
        }
        try {
            measureTrials();
        } catch (IllegalArgumentException wrong) {
            throw new CalledWronglyException(String.valueOf(wrong.getMessage()));
        }
        return ExitCode.OK;
    }

    private void measureTrials() throws IOException {
        if (subject.equals(AGENTS)) {
            new AgentMeasurement(seeds, firstSeed, System.out).run(part, json);
        } else if (subject.equals(TEAM)) {
            new TeamMeasurement(seeds, firstSeed, System.out).run(players, opponent);
        } else {
            RobotType built = robotType();
            new MotionMeasurement(seeds, firstSeed, part, built, System.out)
                    .with(PlayerChecks.all(built))
                    .run(json);
        }
    }

    private RobotType robotType() {
        if (type < 0 || type >= RobotType.values().length) {
            throw new CalledWronglyException("--type " + type + ": give the number of a robot type, 0 to 4.");
        }
        return RobotType.values()[type];
    }
}
