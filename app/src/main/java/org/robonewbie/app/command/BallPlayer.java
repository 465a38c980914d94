package org.robonewbie.app.command;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.team.skill.Dribble;
import org.robonewbie.team.skill.Footwork;
import org.robonewbie.team.skill.Gaze;
import org.robonewbie.team.skill.Kick;
import org.robonewbie.team.skill.KickKind;
import org.robonewbie.team.skill.Limbs;
import org.robonewbie.team.world.Spot;
import org.robonewbie.team.world.WorldModel;

/** A robot that does one thing with the ball as the players of the example team do it: it dribbles, or kicks, straight along the pitch. */
final class BallPlayer extends Agent {

    private static final double FAR_METRES = 10;

    private final boolean dribbles;
    private final WorldModel world = new WorldModel();
    private final Limbs body = new Limbs(nao, walk, motions, lookAround);
    private final Footwork feet = new Footwork(walk);
    private final Dribble dribble = new Dribble(walk, feet);
    private final Kick kick;
    private final Gaze gaze = new Gaze(body);
    private boolean begun;

    private BallPlayer(boolean dribbles, KickKind kind) {
        this.dribbles = dribbles;
        kick = new Kick(body, feet, kind);
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        walk.setStyle(Footwork.STYLE);
    }

    static BallPlayer dribbling() {
        return new BallPlayer(true, KickKind.QUICK);
    }

    static BallPlayer kicking(KickKind kind) {
        return new BallPlayer(false, kind);
    }

    @Override
    protected void think() {
        world.update(nao, fieldView);
        gaze.look(world);
        begun = begun || motions.start("stand"); // before a match each player does, after its beam
        if (!motions.isFinished() || Double.isInfinite(world.ballAgeSeconds())) {
            return;
        }
        if (dribbles) {
            dribble.bringClosely(world, new Spot(world.place().x() + FAR_METRES, 0));
        } else {
            kick.kick(world, 0);
        }
    }
}
