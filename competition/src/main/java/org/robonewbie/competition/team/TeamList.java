package org.robonewbie.competition.team;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads which teams take part, from a file or the command line: one team per line, in the order in which they stand there.
 *
 * <pre>
 * # name = program
 * Red = teams/red
 * Red.members = Ada, Alan
 * Blue = Agent_BetterSoccer
 * Green = python3 green.py --port {port}
 * </pre>
 */
public final class TeamList {

    /** As many teams may take part. */
    public static final int MOST_TEAMS = 10;

    static final String TITLE = "title";
    static final String MEMBERS = "members";
    static final String SEED = "seed";
    static final String TOGETHER = "together";
    static final String FOLDER = "folder";

    private static final Set<String> SETTINGS =
            Set.of(TITLE, MEMBERS, SEED, TOGETHER, FOLDER, "main", "attacker", "goalkeeper");
    private static final int MOST_LETTERS = 20;
    private static final int LETTERS_OF_NUMBER = 3;
    private static final Pattern NAME = Pattern.compile("[A-Za-z0-9_]{1," + MOST_LETTERS + "}");
    private static final Pattern LINE = Pattern.compile("([A-Za-z0-9_.-]+)\\s*=\\s*(.*)");

    private final Map<String, String> programs = new LinkedHashMap<>();
    private final Map<String, Map<String, String>> settings = new TreeMap<>();

    private TeamList() {}

    /**
     * Reads a file of teams.
     *
     * @param file the file
     * @return its teams
     * @throws WrongEntryException if it cannot be read or has a mistake; the message says what to do
     */
    public static List<TeamEntry> read(Path file) {
        try {
            return parse(Files.readAllLines(file));
        } catch (IOException unreadable) {
            throw new WrongEntryException("The file of teams " + file + " cannot be read (in the folder "
                    + Path.of("").toAbsolutePath() + "). Is its name right?");
        }
    }

    /**
     * Reads teams.
     *
     * @param lines {@code NAME = PROGRAM}, {@code NAME.SETTING = VALUE}, or only a program, which then names the team too
     * @return the teams in their order
     * @throws WrongEntryException if there is a mistake; the message says what to do
     */
    public static List<TeamEntry> parse(List<String> lines) {
        TeamList list = new TeamList();
        lines.stream()
                .map(String::strip)
                .filter(line -> !line.isEmpty() && !line.startsWith("#"))
                .forEach(list::add);
        return list.teams();
    }

    private void add(String line) {
        Matcher matcher = LINE.matcher(line);
        if (!matcher.matches()) {
            addTeam(freeName(line), line);
            return;
        }
        String key = matcher.group(1);
        String value = matcher.group(2).strip();
        int dot = key.indexOf('.');
        if (dot < 0) {
            addTeam(key, value);
        } else {
            addSetting(key.substring(0, dot), key.substring(dot + 1), value);
        }
    }

    private void addTeam(String name, String program) {
        if (!NAME.matcher(name).matches()) {
            throw new WrongEntryException(
                    "\"" + name + "\" cannot be the name of a team. Take up to 20 letters, digits and"
                            + " underscores; NAME.title is for a longer one.");
        }
        if (program.isEmpty()) {
            throw new WrongEntryException(
                    "Team " + name + " has no program. Write for example: " + name + " = Agent_SimpleSoccer");
        }
        for (String other : programs.keySet()) {
            if (other.equalsIgnoreCase(name)) {
                throw new WrongEntryException("Two teams are called " + name + ". Give one of them another name.");
            }
        }
        programs.put(name, program);
    }

    private void addSetting(String name, String setting, String value) {
        if (!SETTINGS.contains(setting)) {
            throw new WrongEntryException(
                    "\"" + name + "." + setting + "\" is unknown. After the name of a team may stand: "
                            + String.join(", ", SETTINGS.stream().sorted().toList()) + ".");
        }
        if (setting.equals(SEED) && !value.matches("-?\\d{1,18}")) {
            throw new WrongEntryException(
                    name + ".seed = " + value + " is no whole number. Write for example: " + name + ".seed = 7");
        }
        if (setting.equals(TOGETHER) && !Set.of("yes", "no").contains(value.toLowerCase(Locale.ROOT))) {
            throw new WrongEntryException(name + ".together = " + value + " is not clear. Write yes or no.");
        }
        settings.computeIfAbsent(name, team -> new TreeMap<>()).put(setting, value);
    }

    /** The name of a team, after its folder, file or class. */
    private String freeName(String program) {
        String last = program.split("\\s", -1)[0].replaceFirst("[/\\\\]+$", "").replaceFirst("^.*[/\\\\]", "");
        String base = (last.isEmpty() ? "Team" : last)
                .replaceFirst("\\.(jar|java)$", "")
                .replaceAll("^.*\\.", "")
                .replaceAll("[^A-Za-z0-9_]", "_");
        String free = shortened(base, MOST_LETTERS);
        for (int i = 2; programs.containsKey(free); i++) {
            free = shortened(base, MOST_LETTERS - LETTERS_OF_NUMBER) + "_" + i;
        }
        return free;
    }

    private static String shortened(String name, int letters) {
        return name.substring(0, Math.min(letters, name.length()));
    }

    private List<TeamEntry> teams() {
        for (String name : settings.keySet()) {
            if (!programs.containsKey(name)) {
                throw new WrongEntryException("Something is said of team " + name
                        + ", but no line says what its program is. Write for example: " + name + " = teams/" + name);
            }
        }
        if (programs.size() > MOST_TEAMS) {
            throw new WrongEntryException("A competition has at most " + MOST_TEAMS + " teams, and these are "
                    + programs.size() + ". Hold two groups, each with a folder of results of its own.");
        }
        List<TeamEntry> teams = new ArrayList<>();
        programs.forEach(
                (name, program) -> teams.add(new TeamEntry(name, program, settings.getOrDefault(name, Map.of()))));
        return List.copyOf(teams);
    }
}
