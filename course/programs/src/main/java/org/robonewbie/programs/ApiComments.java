package org.robonewbie.programs;

import com.sun.source.util.JavacTask;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.programs.completion.CommentCollector;
import org.robonewbie.programs.completion.PlainJavadoc;

/** Reads the framework's Javadoc comments from its packaged sources. */
final class ApiComments {

    /** Resource folder that contains the packaged sources. */
    static final String FOLDER = "/META-INF/sources/";

    /** Matches a file's first comment up to the end of the first sentence. */
    private static final Pattern COMMENT = Pattern.compile("(?s)/\\*\\*(.*?\\.)\\s");

    /** Cached comments by class and member, such as {@code setJointSpeed/2}. */
    private static final Map<String, Map<String, String>> READ = new ConcurrentHashMap<>();

    private ApiComments() {}

    /** Returns the comment of a class or member; empty if its source is not packaged. */
    static String of(String className, String key) {
        String outermost = className.replaceFirst("\\$.*", "");
        return outermost.startsWith("org.robonewbie.")
                ? READ.computeIfAbsent(outermost, ApiComments::read).getOrDefault(key, "")
                : "";
    }

    /** Returns the source of a class of the framework; empty if it is not packaged. */
    static Optional<String> source(String className) {
        String path = FOLDER + className.replace('.', '/') + ".java";
        try (InputStream stream = ApiComments.class.getResourceAsStream(path)) {
            return stream == null
                    ? Optional.empty()
                    : Optional.of(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException unreadable) {
            return Optional.empty();
        }
    }

    /** Returns the first sentence of a class's comment without tags; empty if its source is not packaged. */
    static String summary(String className) {
        return source(className)
                .map(COMMENT::matcher)
                .filter(Matcher::find)
                .map(comment -> PlainJavadoc.of(comment.group(1).replaceAll("\\s*\n \\*\\s?", " ")))
                .orElse("");
    }

    private static Map<String, String> read(String className) {
        return source(className)
                .map(text -> JavaSource.of(Path.of(className.replaceAll(".*\\.", "") + ".java"), text)
                        .with(new CompilerMessages(), List.of(), (task, classes) -> comments(task)))
                .orElse(Map.of());
    }

    private static Map<String, String> comments(JavacTask task) throws IOException {
        return CommentCollector.read(task.parse().iterator().next(), Trees.instance(task));
    }
}
