package org.robonewbie.studio;

import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.studio.file.RefusedException;
import org.robonewbie.studio.motion.PhysicalTrial;
import org.robonewbie.studio.motion.RobotDescription;

/** What the motion editor of a page asks for that has no server behind it. */
public final class PageMotions {

    private PageMotions() {}

    /** {@return the robot whose motions are edited, as JSON} */
    public static String robot() {
        return RobotDescription.write(SceneDescriptionWriter.model(NaoModel.of(RobotType.TYPE_0)));
    }

    /** {@return the bodies of all robot types, as JSON} */
    public static String models() {
        return SceneDescriptionWriter.allModels().toString();
    }

    /**
     * Lets a robot with weight and motors play the motion of a file.
     *
     * @param text what is in the file
     * @param start how the robot is before: {@code standing}, {@code back} or {@code front}
     * @return what happened, as JSON
     * @throws RefusedException if the file is no motion or too long; its message says so
     */
    public static String trial(String text, String start) {
        return PhysicalTrial.json(text, start);
    }
}
