package org.robonewbie.competition.team;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.text.ConfusableCharacter;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.programs.CalledWronglyException;

/**
 * Parses a list of teams from a file or the command line, with one team per line.
 *
 * <pre>
 * # name = program
 * Red = teams/red
 * Red.members = Ada, Alan
 * Blue = Agent_BetterSoccer
 * Green = python3 green.py --port {port}
 * </pre>
 *
 * <p>A line without a name is a program, and the team is named after the program's file or first word.
 */
public final class TeamList {

    /** Maximum number of teams. */
    public static final int MAX_TEAMS = 10;

    static final String TITLE = "title";
    static final String MEMBERS = "members";
    static final String SEED = "seed";
    static final String TOGETHER = "together";
    static final String FOLDER = "folder";

    private static final Set<String> SETTINGS =
            Set.of(TITLE, MEMBERS, SEED, TOGETHER, FOLDER, "main", "attacker", "goalkeeper");

    /**
     * Matches a line without a name. An {@code =} in an option of a command is part of the command; any other {@code =}
     * separates a name from a program.
     */
    private static final Pattern COMMAND = Pattern.compile("[^=]*|[^\\s=-][^\\s=]*(\\s[^=]*)?\\s-[^\\s=]*=.*");

    /** Settings that may contain any character, because they are only printed. */
    private static final Set<String> FREE_TEXTS = Set.of(TITLE, MEMBERS);

    private final Map<TeamName, String> programs = new LinkedHashMap<>();
    private final Map<String, Map<String, String>> settings = new TreeMap<>();

    private TeamList() {}

    /**
     * Reads a list of teams from a file.
     *
     * @param file the file
     * @return its teams
     * @throws CalledWronglyException if it cannot be read or parsed; the message says what to do
     */
    public static List<TeamEntry> read(Path file) {
        TeamList list = new TeamList();
        List<String> lines;
        try {
            lines = TextFile.readAndNote(file).lines();
        } catch (UnreadableFileException unreadable) {
            throw new CalledWronglyException(String.valueOf(unreadable.getMessage()));
        }
        for (int i = 0; i < lines.size(); i++) {
            list.add(lines.get(i).strip(), file + ", line " + (i + 1) + ": ");
        }
        return list.teams();
    }

    /**
     * Parses teams.
     *
     * @param lines {@code NAME = PROGRAM}, {@code NAME.SETTING = VALUE}, or just a program, which then also determines
     *     the team's name
     * @return the teams in the order of the lines
     * @throws CalledWronglyException if a line cannot be parsed; the message says what to do
     */
    public static List<TeamEntry> parse(List<String> lines) {
        TeamList list = new TeamList();
        lines.forEach(line -> list.add(line.strip(), ""));
        return list.teams();
    }

    private void add(String line, String place) {
        try {
            if (!line.isEmpty() && !line.startsWith("#")) {
                add(line);
            }
        } catch (CalledWronglyException wrong) {
            throw new CalledWronglyException(place + wrong.getMessage());
        }
    }

    private void add(String line) {
        if (COMMAND.matcher(line).matches()) {
            refuseConfusable(line);
            addTeam(freeName(line), line);
            return;
        }
        int equals = line.indexOf('=');
        String key = line.substring(0, equals).strip();
        String value = line.substring(equals + 1).strip();
        int dot = key.lastIndexOf('.');
        if (dot < 0) {
            refuseConfusable(line);
            addTeam(name(key, value), value);
        } else {
            String setting = key.substring(dot + 1);
            refuseConfusable(FREE_TEXTS.contains(setting) ? key : line);
            addSetting(TeamName.of(key.substring(0, dot)).written(), setting, value);
        }
    }

    private static void refuseConfusable(String text) {
        ConfusableCharacter.firstIn(text).ifPresent(character -> {
            throw new CalledWronglyException("In \"" + text + "\", " + character + ".");
        });
    }

    private static TeamName name(String key, String program) {
        try {
            return TeamName.of(key);
        } catch (CalledWronglyException wrong) {
            throw new CalledWronglyException(
                    wrong.getMessage() + " Write: " + TeamName.near(key).written() + " = " + program);
        }
    }

    private void addTeam(TeamName name, String program) {
        if (program.isEmpty()) {
            throw new CalledWronglyException("Team " + name.written() + " has no program. Add one, for example: "
                    + name.written() + " = Agent_SimpleSoccer");
        }
        for (TeamName other : programs.keySet()) {
            if (other.collidesWith(name)) {
                throw new CalledWronglyException((other.written().equalsIgnoreCase(name.written())
                                ? "Two teams are called " + name.written() + "."
                                : "The teams " + other.written() + " and " + name.written() + " are both called "
                                        + name.ascii() + " in messages and files.")
                        + " Give one of them another name.");
            }
        }
        programs.put(name, program);
    }

    private void addSetting(String name, String setting, String value) {
        if (!SETTINGS.contains(setting)) {
            throw new CalledWronglyException("\"" + name + "." + setting + "\" is unknown."
                    + Spelling.question(setting, SETTINGS) + " The settings of a team are: "
                    + String.join(", ", SETTINGS.stream().sorted().toList()) + ".");
        }
        if (setting.equals(SEED) && !value.matches("-?\\d{1,18}")) {
            throw new CalledWronglyException(
                    name + ".seed = " + value + " is not an integer. For example: " + name + ".seed = 7");
        }
        if (setting.equals(TOGETHER) && !Set.of("yes", "no").contains(value.toLowerCase(Locale.ROOT))) {
            throw new CalledWronglyException(name + ".together = " + value + " is invalid. Write yes or no.");
        }
        Map<String, String> own = settings.computeIfAbsent(name, team -> new TreeMap<>());
        if (own.put(setting, value) != null) {
            throw new CalledWronglyException(
                    "\"" + name + "." + setting + "\" is set twice. Delete one of the two lines.");
        }
    }

    /** Returns an unused name, derived from the name of the folder, file or class. */
    private TeamName freeName(String program) {
        String last = program.split("\\s", -1)[0].replaceFirst("[/\\\\]+$", "").replaceFirst("^.*[/\\\\]", "");
        TeamName name = TeamName.near(last.replaceFirst("\\.(jar|java)$", "").replaceAll("^.*\\.", ""));
        TeamName free = name;
        for (int i = 2; programs.keySet().stream().anyMatch(free::collidesWith); i++) {
            free = name.numbered(i);
        }
        return free;
    }

    private List<TeamEntry> teams() {
        List<String> names = programs.keySet().stream()
                .flatMap(name -> Stream.of(name.written(), name.ascii()))
                .toList();
        for (String name : settings.keySet()) {
            if (!names.contains(name)) {
                throw new CalledWronglyException("There are settings for team " + name
                        + ", but no line for its program." + Spelling.question(name, names)
                        + " For example: " + name + " = teams/" + name);
            }
        }
        if (programs.size() > MAX_TEAMS) {
            throw new CalledWronglyException("A competition can have at most " + MAX_TEAMS + " teams, but there are "
                    + programs.size() + ". Split them into two competitions, each with its own results folder.");
        }
        List<TeamEntry> teams = new ArrayList<>();
        programs.forEach((name, program) -> teams.add(entry(name, program)));
        return List.copyOf(teams);
    }

    private TeamEntry entry(TeamName name, String program) {
        Map<String, String> own = new TreeMap<>(settings.getOrDefault(name.ascii(), Map.of()));
        own.putAll(settings.getOrDefault(name.written(), Map.of()));
        if (!name.ascii().equals(name.written())) {
            own.putIfAbsent(TITLE, name.written());
        }
        return new TeamEntry(name.ascii(), program, own);
    }
}
