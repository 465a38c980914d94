package org.robonewbie.exercises.marking;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Grade.SeededScore;
import org.robonewbie.exercises.Score;
import org.robonewbie.simulator.json.Json;

/**
 * Serves the web edition's pages for a class without accounts: creates a student's submission, lists the programs in received
 * submissions, and writes the table of {@link ClassMarking}. The programs run in the page. Requests and responses are JSON.
 */
public final class ClassService {

    private ClassService() {}

    /**
     * Handles a request.
     *
     * @param action {@code submission}: checks {@link HandIn#json a submission} and returns it; {@code programs}: lists the
     *     programs to grade; {@code table}: writes the table
     * @param request JSON
     * @return JSON, or a sentence if the request is refused
     */
    public static String answer(String action, String request) {
        try {
            return switch (action) {
                case "submission" -> HandIn.parse(request).json();
                case "programs" -> programs(request);
                default -> table(request);
            };
        } catch (IllegalArgumentException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    /**
     * Lists the programs to grade.
     *
     * @param request {@code {"received": [{"source": …, "text": …} or {"source": …, "trouble": …}]}}
     * @return {@code {"seeds": …, "students": […], "senders": [student or "" for each received], "programs": [{"student": …, "exercise": …, "file": …, "files": {…}}],
     *     "troubles": {…}}}
     */
    static String programs(String request) {
        ReceivedWork received = received(parse(request));
        List<JsonObject> programs = new ArrayList<>();
        int seeds = 1;
        for (HandIn work : received.accepted()) {
            seeds = Math.max(seeds, work.seeds());
            work.solved().forEach(exercise -> programs.add(program(work, exercise)));
        }
        return Json.object(
                        "seeds", seeds,
                        "students", received.students(),
                        "senders", received.senders(),
                        "programs", programs,
                        "troubles", received.troubles())
                .toString();
    }

    private static JsonObject program(HandIn work, Exercise exercise) {
        return Json.object(
                "student", work.student(),
                "exercise", exercise.name(),
                "file", exercise.fileName(),
                "files", work.files());
    }

    /**
     * Writes the table and checks for plagiarism.
     *
     * @param request as for {@link #programs}, with the additional members {@code "seeds"} and {@code "marks": [{"student":
     *     …, "exercise": …, "judged": […] or "reason": …}]}; {@code judged} contains trials in the format of an attempt in
     *     {@code CourseService}
     * @return the table's files by name, and a summary as {@code "sentence"}
     */
    static String table(String request) {
        JsonObject read = parse(request);
        ReceivedWork received = received(read);
        List<CopyCheck.Program> programs = new ArrayList<>();
        List<String> students = received.students();
        Set<String> columns = new HashSet<>();
        for (HandIn work : received.accepted()) {
            columns.addAll(work.exercises());
            for (Exercise exercise : work.solved()) {
                columns.add(exercise.name());
                programs.add(new CopyCheck.Program(
                        work.student(), exercise, work.files().getOrDefault(exercise.fileName(), "")));
            }
        }
        List<Mark> marks = new ArrayList<>();
        read.getAsJsonArray("marks").forEach(mark -> marks.add(mark(mark.getAsJsonObject())));
        ClassTable table = new ClassTable(
                Exercises.all().stream()
                        .filter(exercise -> columns.contains(exercise.name()))
                        .toList(),
                students,
                marks,
                received.troubles(),
                CopyCheck.ofPrograms(programs),
                read.get("seeds").getAsInt());
        JsonObject json = new JsonObject();
        table.files().forEach(json::addProperty);
        json.addProperty("sentence", students.size() + " students, " + marks.size() + " programs. " + table.sentence());
        return json.toString();
    }

    private static ReceivedWork received(JsonObject request) {
        ReceivedWork received = new ReceivedWork();
        for (JsonElement each : request.getAsJsonArray("received")) {
            JsonObject entry = each.getAsJsonObject();
            String source = entry.get("source").getAsString();
            if (entry.has("trouble")) {
                received.refuse(source, entry.get("trouble").getAsString());
            } else {
                received.add(source, entry.get("text").getAsString());
            }
        }
        return received;
    }

    private static Mark mark(JsonObject json) {
        String student = json.get("student").getAsString();
        String exercise = json.get("exercise").getAsString();
        if (json.has("reason")) {
            return new Mark(
                    student, exercise, Optional.empty(), json.get("reason").getAsString());
        }
        List<SeededScore> trials = new ArrayList<>();
        for (JsonElement each : json.getAsJsonArray("judged")) {
            JsonObject trial = each.getAsJsonObject();
            trials.add(new SeededScore(
                    trial.get("seed").getAsLong(),
                    new Score(
                            trial.get("passed").getAsBoolean(),
                            trial.get("points").getAsInt(),
                            trial.get("finding").getAsString(),
                            trial.get("hint").getAsString())));
        }
        return new Mark(student, exercise, Optional.of(new Grade(exercise, trials)), "");
    }

    private static JsonObject parse(String request) {
        return JsonParser.parseString(request).getAsJsonObject();
    }
}
