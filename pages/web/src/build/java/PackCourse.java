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
import org.robonewbie.exercises.progress.Badge;
import org.robonewbie.exercises.progress.Worksheet;

/**
 * Writes the exercises for the page, one file per language with titles, goals, hints and starter programs, and the rules of the badges
 * to {@code badges.json}.
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
        JsonArray badges = new JsonArray();
        for (Badge badge : Badge.values()) {
            badges.add(badge(badge));
        }
        Files.writeString(folder.resolve("badges.json"), new Gson().toJson(badges) + "\n");
    }

    private static JsonElement badge(Badge badge) {
        Badge.Rule rule = badge.rule();
        JsonArray counting = new JsonArray();
        rule.counting().forEach(exercise -> counting.add(exercise.name()));
        JsonObject json = new JsonObject();
        json.addProperty("title", badge.title());
        json.add("counting", counting);
        json.addProperty("needed", rule.needed());
        json.addProperty("leastPoints", rule.leastPoints());
        json.addProperty("leastTries", rule.leastTries());
        json.addProperty("alone", rule.alone());
        return json;
    }

    private static JsonElement lesson(Exercise exercise, Language language) {
        Worksheet sheet = Worksheet.of(exercise, language);
        JsonObject lesson = new JsonObject();
        lesson.addProperty("number", exercise.number());
        lesson.addProperty("name", exercise.name());
        lesson.addProperty("fullName", exercise.fullName());
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
