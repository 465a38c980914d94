package org.robonewbie.studio;

import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.studio.file.RefusedException;
import org.robonewbie.studio.motion.PhysicalTrial;
import org.robonewbie.studio.motion.RobotDescription;

/** Handles the motion editor's requests locally, for a page without a server. */
public final class PageMotions {

    private PageMotions() {}

    /**
     * Describes a robot for the motion editor.
     *
     * @param name name of a model other than the NAO's; empty for the NAO
     * @return the description as JSON
     * @throws RefusedException if there is no such model
     */
    public static String robot(String name) {
        return name.isEmpty()
                ? RobotDescription.write(SceneDescriptionWriter.model(NaoModel.of(RobotType.TYPE_0)))
                : RobotDescription.write(name);
    }

    /** {@return the bodies of all robot types by name, as JSON} */
    public static String models() {
        return SceneDescriptionWriter.allModels().toString();
    }

    /**
     * Plays a motion file on a robot with full physics.
     *
     * @param text contents of the file
     * @param start initial posture: {@code standing}, {@code back} or {@code front}
     * @return the result as JSON
     * @throws RefusedException if the text is not a valid motion or is too long
     */
    public static String trial(String text, String start) {
        return PhysicalTrial.json(text, start);
    }
}
