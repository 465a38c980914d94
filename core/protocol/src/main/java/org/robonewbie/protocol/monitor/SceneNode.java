package org.robonewbie.protocol.monitor;

/**
 * A node of the scene graph that monitors draw. Inner nodes are transforms; leaves are meshes and lights.
 *
 * <p>Nodes track what was last sent, so that the next message can omit unchanged parts. A scene can therefore be used for one
 * stream of messages only.
 */
public sealed interface SceneNode permits TransformNode, MeshNode, LightNode {}
