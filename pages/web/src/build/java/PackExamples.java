import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.robonewbie.programs.ExampleSources;

/**
 * Adds the sources of the examples to the page, and templates for new programs, which contain the class name {@link
 * ExampleSources#TEMPLATE}: one for each example, and the shortest program.
 *
 * <p>Usage: {@code java -cp CLASS_PATH PackExamples.java FOLDER}. The file {@code index} in the folder lists the examples.
 */
final class PackExamples {

    private PackExamples() {}

    public static void main(String[] args) throws IOException {
        Path folder = Path.of(args[0]);
        Path templates = Files.createDirectories(folder.resolve("new"));
        ExampleSources sources = new ExampleSources();
        Files.writeString(templates.resolve(ExampleSources.TEMPLATE + ".java"), sources.template(Optional.empty()));
        for (String name : Files.readAllLines(folder.resolve("index"))) {
            String file = name + ".java";
            String text = sources.text(name).orElseThrow(() -> new IOException("There is no example " + name + "."));
            Files.writeString(folder.resolve(file), text);
            Files.writeString(templates.resolve(file), sources.template(Optional.of(text)));
        }
    }
}
