import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.studio.ModuleGraph;

/**
 * Assembles the web page from the studio's files and those of the web edition: adds the style sheet, preloads scripts, links the page from
 * the documentation, replaces terminal commands in worksheets, and writes the service worker's list of files.
 *
 * <p>Usage: {@code java -cp CLASS_PATH FinishPage.java FOLDER}
 */
final class FinishPage {

    private static final String LIST = "files.json";
    private static final String SERVICE_WORKER = "service-worker.js";
    /** Folder that is not cached, because a teacher may change the solutions at any time. */
    private static final String SOLUTIONS = "solutions/";

    private static final String STYLE = "    <link rel=\"stylesheet\" href=\"page/page.css\" />\n  </head>";
    private static final String TRY = "<a class=\"try\" href=\"";
    private static final Pattern WORKSHEET = Pattern.compile("docs/exercises/(de/)?\\d.*");
    private static final Pattern COMMANDS =
            Pattern.compile("(<h2 id=\"begin(?:nen)?\">.*?</h2>\\s*)<pre.*?</pre>", Pattern.DOTALL);
    private static final String ROOM = "$1<p>Open the exercise in the room <em>Program</em>: it is in the list of programs. <em>Check</em>"
            + " grades your program and shows the trials.</p>";
    private static final String GERMAN_ROOM = "$1<p>Öffne die Aufgabe im Raum <em>Program</em>: Sie steht in der Liste der Programme."
            + " <em>Check</em> bewertet dein Programm und zeigt die Versuche.</p>";
    private static final int VERSION_DIGITS = 16;

    private FinishPage() {}

    public static void main(String[] args) throws IOException, NoSuchAlgorithmException {
        Path folder = Path.of(args[0]);
        Path index = folder.resolve("index.html");
        ModuleGraph scripts = new ModuleGraph(name -> text(folder.resolve(name)));
        Files.writeString(
                index, scripts.withPreloads(Files.readString(index)).replace("  </head>", STYLE));
        offerToTry(folder);
        List<Path> files = files(folder);
        MessageDigest digest = MessageDigest.getInstance("SHA-256");
        for (Path file : files) {
            digest.update(name(folder, file).getBytes(StandardCharsets.UTF_8));
            digest.update(Files.readAllBytes(file));
        }
        String version = HexFormat.of().formatHex(digest.digest()).substring(0, VERSION_DIGITS);
        String names = files.stream().map(file -> "\"" + name(folder, file) + "\"").collect(Collectors.joining(",\n    "));
        Files.writeString(
                folder.resolve(LIST),
                "{\n  \"version\": \"" + version + "\",\n  \"files\": [\n    " + names + "\n  ]\n}\n");
    }

    /** Adds a link to the web edition's front page to each page of the documentation. */
    private static void offerToTry(Path folder) throws IOException {
        Path documentation = folder.resolve("docs");
        try (Stream<Path> pages = Files.walk(documentation)) {
            for (Path page : pages.filter(file -> file.toString().endsWith(".html")).toList()) {
                String text = Files.readString(page);
                if (text.contains(TRY)) {
                    continue;
                }
                String way = "../".repeat(folder.relativize(page).getNameCount() - 1);
                String offered = text.replaceFirst("<input id=\"search\"", TRY + way + "index.html\">Try it now</a>\n      $0");
                if (offered.equals(text) && text.contains("class=\"brand\"")) {
                    throw new IOException(page + " has no search field; the link \"Try it now\" belongs in front of it.");
                }
                Files.writeString(page, withoutCommands(offered, name(folder, page)));
            }
        }
    }

    /** Replaces the terminal commands of a worksheet with instructions for the browser. */
    private static String withoutCommands(String text, String page) throws IOException {
        Matcher worksheet = WORKSHEET.matcher(page);
        if (!worksheet.matches()) {
            return text;
        }
        String result = COMMANDS.matcher(text).replaceFirst(worksheet.group(1) == null ? ROOM : GERMAN_ROOM);
        if (result.equals(text)) {
            throw new IOException(page + " does not begin with the commands of its exercise.");
        }
        return result;
    }

    private static Optional<String> text(Path file) {
        try {
            return Files.isRegularFile(file) ? Optional.of(Files.readString(file)) : Optional.empty();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static List<Path> files(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            return all.filter(Files::isRegularFile)
                    .filter(file -> !List.of(LIST, SERVICE_WORKER).contains(name(folder, file)))
                    .filter(file -> !name(folder, file).startsWith(SOLUTIONS))
                    .sorted()
                    .toList();
        }
    }

    private static String name(Path folder, Path file) {
        return folder.relativize(file).toString().replace('\\', '/');
    }
}
