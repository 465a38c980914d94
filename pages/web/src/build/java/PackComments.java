import com.google.gson.Gson;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.robonewbie.programs.completion.CommentCollector;
import org.robonewbie.web.compiling.ProgramLibrary;

/**
 * Writes the Javadoc of those RoboNewbie classes that programs may use, as plain text by class and member, for the
 * page's code completion.
 *
 * <p>Usage: {@code java -cp CLASS_PATH PackComments.java ROOT FILE}
 */
final class PackComments {

    private static final List<String> MODULES = List.of("core/robot", "core/agent", "course/team");

    private PackComments() {}

    public static void main(String[] args) throws IOException {
        Map<String, Map<String, String>> comments = new TreeMap<>();
        for (String module : MODULES) {
            Path sources = Path.of(args[0], module, "src", "main", "java");
            try (Stream<Path> files = Files.walk(sources)) {
                for (Path file :
                        files.filter(each -> each.toString().endsWith(".java")).toList()) {
                    String name = sources.relativize(file)
                            .toString()
                            .replaceAll("[/\\\\]", ".")
                            .replaceFirst("\\.java$", "");
                    if (ProgramLibrary.has(name)) {
                        comments.put(name, comments(file));
                    }
                }
            }
        }
        Files.writeString(Path.of(args[1]), new Gson().toJson(comments) + "\n");
        System.out.println("documentation of " + comments.size() + " classes");
    }

    private static Map<String, String> comments(Path file) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
            JavacTask task =
                    (JavacTask) compiler.getTask(null, files, null, null, null, files.getJavaFileObjects(file));
            CompilationUnitTree unit = task.parse().iterator().next();
            return new TreeMap<>(CommentCollector.read(unit, Trees.instance(task)));
        }
    }
}
