#include "report/scene/scene_script.hpp"

namespace clast::report_detail {

// Drawing starts when the view is first seen, so that the page opens at once. `clastScene` is there
// for the console and for tests.
const char* const kSceneScript = R"js(
var clastScene=(function(){
  var box=document.getElementById('scene'),view=box.querySelector('.view');
  var part=function(name){return box.querySelector('[data-scene='+name+']')};
  var data,renderer,scene,camera,controls,bodies=[],paths={},time=0,playing=false,last=0;
  var hidden={},scale=1,started=false,wanted=false;

  function numbers(type,text){
    var raw=atob(text),bytes=new Uint8Array(raw.length);
    for(var i=0;i<raw.length;i++)bytes[i]=raw.charCodeAt(i);
    return new type(bytes.buffer);
  }
  function geometry(mesh){
    var g=new THREE.BufferGeometry();
    g.setAttribute('position',new THREE.BufferAttribute(numbers(Float32Array,mesh.vertices),3));
    g.setIndex(new THREE.BufferAttribute(numbers(Uint32Array,mesh.triangles),1));
    return g;
  }
  /* Flat faces: every triangle gets corners, a normal and the tint of its zone to itself. */
  function ground(){
    var g=geometry(data.terrain).toNonIndexed(),zones=numbers(Uint16Array,data.terrain.zones);
    var colours=new Float32Array(9*zones.length);
    var tints=data.tints.map(function(t){return new THREE.Color(t)});
    for(var t=0;t<zones.length;t++)for(var k=0;k<3;k++)
      (tints[zones[t]]||tints[0]).toArray(colours,9*t+3*k);
    g.setAttribute('color',new THREE.BufferAttribute(colours,3));
    g.computeVertexNormals();
    return new THREE.Mesh(g,new THREE.MeshLambertMaterial({vertexColors:THREE.VertexColors,side:THREE.DoubleSide}));
  }
  function walls(){
    var floor=new THREE.Box3().setFromObject(scene);
    data.barriers.forEach(function(b){
      var points=[],last=b.through.length-1;
      b.through.forEach(function(p,i){points.push([p,floor.max.z],[p,floor.min.z],[p,floor.max.z]);if(i<last)points.push([b.through[i+1],floor.max.z])});
      b.through.slice().reverse().forEach(function(p){points.push([p,floor.min.z])});
      var g=new THREE.BufferGeometry().setFromPoints(points.map(function(p){return new THREE.Vector3(p[0][0],p[0][1],p[1])}));
      var line=new THREE.Line(g,new THREE.LineBasicMaterial({color:0xaa3377}));
      line.name=b.name;scene.add(line);
    });
  }
  function blocks(){
    data.bodies.forEach(function(body,number){
      var runs=data.runs.filter(function(run){return run.body===number});
      bodies.push({runs:runs,group:body.group,mesh:null});
      if(!runs.length)return;
      var g=geometry(body).toNonIndexed();g.computeVertexNormals();
      var mesh=new THREE.InstancedMesh(g,new THREE.MeshLambertMaterial({color:body.colour}),runs.length);
      mesh.frustumCulled=false;scene.add(mesh);bodies[number].mesh=mesh;
    });
  }
  function lines(){
    var points={};
    data.runs.forEach(function(run){
      var body=data.bodies[run.body],list=points[body.group]=points[body.group]||{colour:body.colour,at:[]};
      for(var k=run.first;k+1<run.first+run.count;k++)for(var e=0;e<2;e++)
        list.at.push(data.frames[8*(k+e)+1],data.frames[8*(k+e)+2],data.frames[8*(k+e)+3]);
    });
    Object.keys(points).forEach(function(group){
      var g=new THREE.BufferGeometry();
      g.setAttribute('position',new THREE.BufferAttribute(new Float32Array(points[group].at),3));
      paths[group]=new THREE.LineSegments(g,new THREE.LineBasicMaterial({color:points[group].colour,transparent:true,opacity:.35}));
      scene.add(paths[group]);
    });
  }
  var from,to,place,size,matrix;
  /* The last stored state before `time`, by halving; then a straight way and an even turn. */
  function state(run){
    var f=data.frames,low=run.first,high=run.first+run.count-1;
    if(f[8*low]>=time)high=low;else if(f[8*high]<=time)low=high;
    while(high-low>1){var middle=(low+high)>>1;if(f[8*middle]<=time)low=middle;else high=middle}
    var a=8*low,b=8*high,w=high>low?(time-f[a])/(f[b]-f[a]):0;
    place.set(f[a+1]+w*(f[b+1]-f[a+1]),f[a+2]+w*(f[b+2]-f[a+2]),f[a+3]+w*(f[b+3]-f[a+3]));
    from.set(f[a+5],f[a+6],f[a+7],f[a+4]);to.set(f[b+5],f[b+6],f[b+7],f[b+4]);
    from.slerp(to,w);
  }
  function draw(){
    bodies.forEach(function(body){
      if(!body.mesh)return;
      size.setScalar(scale);
      body.mesh.visible=!hidden[body.group];
      body.runs.forEach(function(run,i){state(run);matrix.compose(place,from,size);body.mesh.setMatrixAt(i,matrix)});
      body.mesh.instanceMatrix.needsUpdate=true;
    });
    Object.keys(paths).forEach(function(group){paths[group].visible=part('paths').checked&&!hidden[group]});
    renderer.render(scene,camera);
    if(data.runs.length){state(data.runs[0]);box.dataset.first=[place.x,place.y,place.z].map(function(x){return x.toFixed(3)}).join(' ')}
    box.dataset.triangles=renderer.info.render.triangles;
  }
  function soon(){if(!wanted){wanted=true;requestAnimationFrame(function(){wanted=false;draw()})}}
  function seek(t){
    time=Math.max(0,Math.min(t,data.duration));
    part('time').value=1000*time/(data.duration||1);
    part('clock').textContent=time.toFixed(1)+' s';
    soon();
  }
  function tick(now){
    if(!playing)return;
    seek(time+Math.min(.1,(now-last)/1000));last=now;
    if(time>=data.duration)play(false);else requestAnimationFrame(tick);
  }
  function play(on){
    playing=on;part('play').textContent=on?'Pause':'Play';
    if(!on)return;
    if(time>=data.duration)seek(0);
    last=performance.now();requestAnimationFrame(tick);
  }
  function fit(){
    var width=view.clientWidth,height=Math.max(320,Math.round(.56*width));
    renderer.setSize(width,height);camera.aspect=width/height;camera.updateProjectionMatrix();soon();
  }
  function start(){
    if(started)return;started=true;
    clastRun('three-code');clastRun('orbit-code');
    from=new THREE.Quaternion();to=new THREE.Quaternion();place=new THREE.Vector3();size=new THREE.Vector3();matrix=new THREE.Matrix4();
    try{renderer=new THREE.WebGLRenderer({antialias:true})}
    catch(e){view.textContent='This browser draws no 3-D graphics (WebGL is off).';return}
    data=JSON.parse(clastUnpacked('scene-data'));
    data.frames=numbers(Float32Array,data.frames);
    scene=new THREE.Scene();scene.background=new THREE.Color(0xeef3f7);
    scene.add(new THREE.HemisphereLight(0xffffff,0x8a8f96,.75));
    var sun=new THREE.DirectionalLight(0xffffff,.55);sun.position.set(-1,1,1.4);scene.add(sun);
    scene.add(ground());walls();blocks();lines();
    view.appendChild(renderer.domElement);
    camera=new THREE.PerspectiveCamera(40,1,.05,1e5);camera.up.set(0,0,1);
    var ways=new THREE.Box3();data.runs.forEach(function(run){for(var k=run.first;k<run.first+run.count;k++)
      ways.expandByPoint(place.fromArray(data.frames,8*k+1))});
    var middle=ways.getCenter(new THREE.Vector3()),reach=Math.max(5,ways.getSize(size).length());
    camera.position.set(middle.x+.25*reach,middle.y-1.15*reach,middle.z+.75*reach);
    controls=new THREE.OrbitControls(camera,renderer.domElement);controls.target.copy(middle);controls.update();
    controls.addEventListener('change',soon);
    part('time').addEventListener('input',function(){play(false);seek(this.value*data.duration/1000)});
    part('play').addEventListener('click',function(){play(!playing)});
    part('paths').addEventListener('change',soon);
    part('size').addEventListener('change',function(){scale=+this.value;soon()});
    box.querySelectorAll('[data-group]').forEach(function(key){
      key.addEventListener('change',function(){hidden[key.dataset.group]=!key.checked;soon()});
    });
    addEventListener('resize',fit);
    fit();seek(0);box.dataset.runs=data.runs.length;
  }
  if('IntersectionObserver' in window)new IntersectionObserver(function(entries,watcher){
    if(entries.some(function(e){return e.isIntersecting})){watcher.disconnect();start()}
  },{rootMargin:'200px'}).observe(box);
  else addEventListener('load',start);
  return {start:start,seek:seek,draw:draw};
})();
)js";

}  // namespace clast::report_detail
