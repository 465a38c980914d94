import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.Stream;

/**
 * Creates a project with {@code robonewbie new} and adds it to the page, which fills it with the user's programs for
 * download. If RoboNewbie's jar has not been built, the page offers no project, and the build says so.
 *
 * <p>Usage: {@code java -cp CLASS_PATH PackProject.java ROOT FOLDER}
 */
final class PackProject {

    private static final String NAME = "my-robot";
    private static final String PACKAGE = "myrobot";

    private PackProject() {}

    public static void main(String[] args) throws IOException, InterruptedException {
        Path root = Path.of(args[0]).toAbsolutePath().normalize();
        Path folder = Path.of(args[1]);
        Files.createDirectories(folder);
        JsonObject project = new JsonObject();
        project.addProperty("name", NAME);
        project.addProperty("package", PACKAGE);
        JsonObject texts = new JsonObject();
        JsonArray libraries = new JsonArray();
        Path jar = root.resolve("app/target/robonewbie.jar");
        if (Files.isRegularFile(jar)) {
            pack(made(root, jar), folder, texts, libraries);
        } else {
            System.out.println("The page will offer no project for download: " + jar + " is missing.");
        }
        project.add("texts", texts);
        project.add("libraries", libraries);
        Files.writeString(folder.resolve("project.json"), new Gson().toJson(project) + "\n");
    }

    /** Creates a project by running RoboNewbie's jar. */
    private static Path made(Path root, Path jar) throws IOException, InterruptedException {
        Path place = Files.createTempDirectory("project");
        Process program = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-Drobonewbie.home=" + root,
                        "-jar",
                        jar.toString(),
                        "new",
                        NAME,
                        "--package",
                        PACKAGE)
                .directory(place.toFile())
                .inheritIO()
                .start();
        if (program.waitFor() != 0) {
            throw new IOException("\"robonewbie new\" failed.");
        }
        return place.resolve(NAME);
    }

    private static void pack(Path project, Path folder, JsonObject texts, JsonArray libraries) throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.walk(project)) {
            files = all.filter(Files::isRegularFile).sorted().toList();
        }
        for (Path file : files) {
            String path = project.relativize(file).toString().replace('\\', '/');
            if (path.endsWith(".jar")) {
                libraries.add(path);
                Files.copy(file, folder.resolve(file.getFileName()), StandardCopyOption.REPLACE_EXISTING);
            } else {
                texts.addProperty(path, Files.readString(file, StandardCharsets.UTF_8));
            }
        }
    }
}
