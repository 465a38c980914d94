package org.robonewbie.studio.service;

import java.util.List;
import java.util.Locale;

/**
 * All requests of pages: the HTTP method, and the path below {@code /api/}. Words in capital letters stand for names; PATH is one or more
 * segments. Parameters are named by the service that answers.
 */
public enum PageRequest {
    /** Lists the files of a kind. */
    LIST_FILES("GET files/KIND"),
    /** Reads a file. */
    READ_FILE("GET files/KIND/PATH"),
    /** Writes a file; the header Known-Version contains the version that the page has read, empty for a new file. */
    WRITE_FILE("PUT files/KIND/PATH"),
    /** Deletes a file; the header Known-Version limits this to a version. */
    DELETE_FILE("DELETE files/KIND/PATH"),

    /** Returns whether programs can be written, and the first one. */
    PROGRAMS("GET programs"),
    /** Returns the source of a new program, a copy of the parameter {@code example} if there is one. */
    NEW_PROGRAM("GET programs/new/PATH"),
    /** Returns the compiler's diagnostics for the text in the editor. */
    CHECK_PROGRAM("POST programs/check/PATH"),
    /** Returns completion proposals for the text in the editor at the index {@code at}. */
    COMPLETE_PROGRAM("POST programs/complete/PATH"),
    /** Compiles a saved program and replaces the running one; {@code world=keep} continues the game. */
    RUN_PROGRAM("POST programs/run/PATH"),
    /** Returns the state of the running program. */
    RUNNING_PROGRAM("GET programs/run"),
    /** Stops the running program. */
    STOP_PROGRAM("DELETE programs/run"),

    /** Describes the NAO for the motion editor. */
    NAO("GET robot"),
    /** Describes a robot for the motion editor. */
    ROBOT("GET robot/NAME"),
    /** Plays a motion with physics; the header Start is standing, back or front. */
    TRY_MOTION("POST trial"),

    /** Lists the exercises with the student's progress. */
    COURSE("GET course"),
    /** Sets the language to {@code code}. */
    SET_LANGUAGE("POST course/language"),
    /** Returns the state of the current attempt. */
    ATTEMPT("GET course/attempt"),
    /** Ends the current attempt. */
    END_ATTEMPT("DELETE course/attempt"),
    /** Writes the starter program of an exercise. */
    WRITE_STARTER("PUT course/NAME"),
    /** Starts an attempt with {@code program} and a number of {@code trials}. */
    BEGIN_ATTEMPT("POST course/NAME"),
    /** Returns the hints opened so far. */
    HELP("GET course/NAME/help"),
    /** Opens the next hint. */
    OPEN_HINT("POST course/NAME/hint"),
    /** Returns the sample solution. */
    SOLUTION("POST course/NAME/solution"),

    /** Lists the scenes. */
    SCENES("GET scenes"),
    /** Saves the world, or renames the scene {@code was}; {@code replace=yes} replaces a scene. */
    SAVE_SCENE("PUT scenes/NAME"),
    /** Restores a scene. */
    RESTORE_SCENE("POST scenes/NAME"),
    /** Deletes a scene. */
    DELETE_SCENE("DELETE scenes/NAME"),
    /** Continues from the cycle {@code moment} of a recording. */
    START_FROM("POST start/NAME"),

    /** Lists the recordings. */
    RECORDINGS("GET recordings"),
    /** Renames the recording {@code was}, or brings back a deleted one with {@code removed=yes}. */
    RENAME_RECORDING("PUT recordings/NAME"),
    /** Deletes a recording. */
    DELETE_RECORDING("DELETE recordings/NAME"),
    /** Returns a recording's entry in the list. */
    CARD("GET cards/NAME"),
    /** Returns what a recording contains, without the {@code events} and {@code pieces} that the page knows. */
    INDEX("GET index/NAME"),
    /** Returns a {@code piece} of a recording without the first {@code skip} bytes. */
    PIECE("GET pieces/NAME"),
    /** Returns a recording as a SimSpark log. */
    LOG("GET log/NAME"),
    /** Returns log entries and drawings of a run, without the first {@code skip} bytes. */
    NOTES("GET notes/NAME"),
    /** Returns the bodies of all robot types. */
    MODELS("GET models"),
    /** Protects a recording from being deleted automatically. */
    STAR("PUT stars/NAME"),
    /** Removes this protection. */
    UNSTAR("DELETE stars/NAME"),
    /** Sets a bookmark with a {@code note} at {@code seconds}. */
    SET_BOOKMARK("PUT bookmarks/NAME"),
    /** Removes the bookmark at {@code seconds}. */
    REMOVE_BOOKMARK("DELETE bookmarks/NAME");

    private static final String PATH = "PATH";

    private final String method;
    private final String place;

    PageRequest(String text) {
        int space = text.indexOf(' ');
        this.method = text.substring(0, space);
        this.place = text.substring(space + 1);
    }

    /**
     * Returns whether this is the request with a method and path.
     *
     * @param name HTTP method
     * @param path decoded segments of the path below {@code /api/}
     * @return whether they fit; a path may fit several requests, the first of which is meant
     */
    public boolean fits(String name, List<String> path) {
        List<String> segments = List.of(place.split("/", -1));
        boolean isLong = segments.contains(PATH) && path.size() > segments.size();
        if (!method.equals(name) || (path.size() != segments.size() && !isLong)) {
            return false;
        }
        for (int i = 0; i < segments.size(); i++) {
            if (!isVariable(segments.get(i)) && !segments.get(i).equals(path.get(i))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isVariable(String segment) {
        return segment.equals(segment.toUpperCase(Locale.ROOT));
    }

    /** {@return the method and the path} */
    @Override
    public String toString() {
        return method + " " + place;
    }
}
