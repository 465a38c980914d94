import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Language;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.progress.Worksheet;

/**
 * Writes what the page tells about the exercises, a file for each language: title, goal and hints of each, and the program to begin
 * with.
 *
 * <p>Usage: {@code java -cp CLASS_PATH PackCourse.java FOLDER}
 */
final class PackCourse {

    private PackCourse() {}

    public static void main(String[] args) throws IOException {
        Path folder = Path.of(args[0]);
        Files.createDirectories(folder);
        for (Language language : Language.values()) {
            JsonArray lessons = new JsonArray();
            Exercises.all().stream()
                    .forEach(exercise -> lessons.add(lesson(exercise, language)));
            Files.writeString(folder.resolve(language.code() + ".json"), new Gson().toJson(lessons) + "\n");
        }
    }

    private static JsonElement lesson(Exercise exercise, Language language) {
        Worksheet sheet = Worksheet.of(exercise, language);
        JsonObject lesson = new JsonObject();
        lesson.addProperty("number", exercise.number());
        lesson.addProperty("name", exercise.name());
        lesson.addProperty("title", sheet.title());
        lesson.addProperty("goal", language.translated(exercise.goal()));
        lesson.addProperty("level", language.translated(exercise.level()));
        lesson.addProperty("minutes", exercise.minutes());
        lesson.addProperty("points", Score.MOST_POINTS);
        lesson.addProperty("worksheet", "docs/exercises/" + language.worksheet(exercise) + ".html");
        lesson.addProperty("file", exercise.className() + ".java");
        lesson.addProperty("startCode", exercise.startCode());
        JsonArray hints = new JsonArray();
        sheet.hints().forEach(hints::add);
        lesson.add("hints", hints);
        return lesson;
    }
}
