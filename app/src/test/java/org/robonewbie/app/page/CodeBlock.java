package org.robonewbie.app.page;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.app.Project;

/**
 * A fenced block of code on a page. A comment in the line before it, which readers do not see, tells the test what to do with it:
 *
 * <pre>
 * &lt;!-- test: --seconds 2 --&gt;              runs the commands with this option instead of their own
 * &lt;!-- test: file answers.csv --&gt;          writes the block into a file for the commands that follow
 * &lt;!-- test: skip, takes an hour --&gt;       does not run it
 * </pre>
 *
 * @param page the file
 * @param line number of the line in which the code begins
 * @param language what follows the fence, such as {@code java}
 * @param mark text of the comment, empty without one
 * @param code the lines between the fences
 */
public record CodeBlock(Path page, int line, String language, String mark, String code) {

    private static final String FILE = "file ";
    private static final Pattern BLOCK =
            Pattern.compile("(?ms)^(?:<!-- test: ([^\\n]*?) -->\\R)?```(\\w*)\\R(.*?)^```");
    private static final Pattern TYPE =
            Pattern.compile("(?m)^(?:public |abstract |final )*(?:class|record|interface|enum) (\\w+)");
    private static final Pattern METHOD = Pattern.compile("(?m)^(?:@Override|(?:public|protected|private) [^=;]+\\{)");
    private static final Pattern MODULE = Pattern.compile("^python -m ([^#]+)");
    private static final Pattern PYTHON_IMPORT = Pattern.compile("(?m)^(?:import|from) .*");
    private static final Pattern IMPORT = Pattern.compile("(?m)^import .*;\\R");

    /** Lists the pages with code: those of the documentation, and that of the Python package. */
    public static Stream<Path> pages() {
        return Stream.concat(Project.pages().stream(), Stream.of(Project.ROOT.resolve("research/python/README.md")));
    }

    /** Lists the blocks of a page from top to bottom. */
    public static List<CodeBlock> on(Path page) {
        String text = Project.read(page);
        return BLOCK.matcher(text)
                .results()
                .map(block -> new CodeBlock(
                        page,
                        1 + (int) text.substring(0, block.start(3)).lines().count(),
                        block.group(2),
                        Optional.ofNullable(block.group(1)).orElse(""),
                        block.group(3)))
                .toList();
    }

    /** Lists the blocks of all pages. */
    public static Stream<CodeBlock> all() {
        return pages().flatMap(page -> on(page).stream());
    }

    /** Lists the blocks of Java of all pages. */
    public static Stream<CodeBlock> ofJava() {
        return all().filter(block -> block.language.equals("java"));
    }

    /** Returns whether a test may run the block. */
    public boolean isRun() {
        return !mark.startsWith("skip");
    }

    /** {@return whether the block is a program that runs until its robot is stopped} */
    public boolean isAgent() {
        return isProgram() && (code.contains(".run(args)") || code.contains("Nao.connect(args)"));
    }

    /** {@return whether the block is a program with an end} */
    public boolean isExperiment() {
        return isProgram() && !isAgent();
    }

    private boolean isProgram() {
        return code.contains("void main(");
    }

    /** {@return the options of the comment} */
    public String options() {
        return mark.startsWith("--") ? mark : "";
    }

    /** {@return the name of the file whose content the block shows} */
    public Optional<String> fileName() {
        return mark.startsWith(FILE) ? Optional.of(mark.substring(FILE.length())) : Optional.empty();
    }

    /** {@return the commands of RoboNewbie in the block} */
    public List<Command> commands() {
        return shellLines()
                .flatMap(text -> Command.of(text).stream())
                .map(command -> command.with(options()))
                .toList();
    }

    /** {@return the modules of Python that the block starts, with their arguments, such as {@code robonewbie.parquet dataset}} */
    public List<String> pythonModules() {
        return shellLines()
                .flatMap(text -> MODULE.matcher(text).results())
                .map(module -> module.group(1).strip())
                .toList();
    }

    private Stream<String> shellLines() {
        boolean isShell = language.equals("sh") || language.isEmpty();
        return isShell ? code.replaceAll("\\\\\\R\\s*", "").lines() : Stream.empty();
    }

    /** {@return the imports of a block of Python} */
    public String pythonImports() {
        return PYTHON_IMPORT.matcher(code).results().map(MatchResult::group).collect(Collectors.joining("\n"));
    }

    /** {@return the name of the class in a block of Java} */
    public String className() {
        return TYPE.matcher(code)
                .results()
                .map(type -> type.group(1))
                .findFirst()
                .orElse("Lines");
    }

    /** {@return the block of Java as a file that compiles: members and statements are inside of an agent} */
    public String sourceFile() {
        if (TYPE.matcher(code).find()) {
            return code;
        }
        String imports = String.join(
                "", IMPORT.matcher(code).results().map(MatchResult::group).toList());
        String lines = IMPORT.matcher(code).replaceAll("");
        String members =
                METHOD.matcher(lines).find() ? lines : "void lines(String[] args) throws Exception {\n" + lines + "\n}";
        return imports
                + "import org.robonewbie.agent.*; import org.robonewbie.agent.perception.*; import org.robonewbie.nao.*;\n"
                + "class Lines extends Agent {\n" + members + "\n}";
    }

    @Override
    public String toString() {
        return Project.ROOT.relativize(page) + ":" + line;
    }
}
