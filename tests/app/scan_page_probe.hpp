#pragma once
/// Script for `probed`: the pictures of a page of `clast reconstruct --report`, as they are drawn.
namespace clast {

/// Pictures as they are drawn, colours counted, as JSON in an element that the test reads.
inline constexpr const char* kScanPageProbe = R"(<script>
window.addEventListener('load',function(){
var probe={strips:[]};
document.querySelectorAll('figure').forEach(function(figure){
  var strip={orange:0,red:0,rock:0,views:0};
  var images=Array.from(figure.querySelectorAll('image'));
  strip.views=images.length;
  probe.strips.push(strip);
  images.forEach(function(image){
    var drawn=new Image();drawn.src=image.getAttribute('href');
    var sheet=document.createElement('canvas');
    (probe.waits=probe.waits||[]).push(drawn.decode().then(function(){
      sheet.width=drawn.naturalWidth;sheet.height=drawn.naturalHeight;
      var pen=sheet.getContext('2d');pen.drawImage(drawn,0,0);
      var d=pen.getImageData(0,0,sheet.width,sheet.height).data;
      for(var i=0;i<d.length;i+=4){
        var r=d[i],g=d[i+1],b=d[i+2];
        if(r>1.4*g&&g>1.8*b&&r>60)strip.orange++;
        else if(r>150&&g<60&&b<80)strip.red++;
        else if(r<250&&Math.abs(r-g)<30&&Math.abs(g-b)<40)strip.rock++;
      }
    }));
  });
});
var table=document.querySelector('table');
probe.sorted=[];
if(table&&table.tHead.rows[0].cells.length>6){
  var head=table.tHead.rows[0].cells[6];head.click();
  probe.sorted=Array.from(table.tBodies[0].rows).map(function(r){return parseFloat(r.cells[6].textContent)});
}
probe.links=Array.from(document.querySelectorAll('td a')).map(function(a){return a.getAttribute('href')});
probe.thumbs=Array.from(document.querySelectorAll('td img')).filter(function(i){return i.naturalWidth>0}).length;
Promise.all(probe.waits||[]).then(function(){
  delete probe.waits;
  var told=document.createElement('pre');told.id='probe';told.textContent=JSON.stringify(probe);
  document.body.appendChild(told);
});
});
</script></body>)";

}  // namespace clast
